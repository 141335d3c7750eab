// The test that would tell: what is expected of it, against drawn noise; its motion within limits.
#include "identify/next_test/next_test.h"

#include <algorithm>
#include <random>

#include "identify/fit/accept.h"
#include "identify/fit/near_fit.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;

constexpr int kRivalRows = 120;

/// y = friction.scale sin(w t) + bend of the line's oil on cos(w t): two numbers, two waves.
class TwoWaves final : public ForwardModel {
 public:
  explicit TwoWaves(double noise) {
    measured_.push_back({"load_cell_N", std::vector<double>(kRivalRows, 0.0), noise});
  }
  const std::vector<MeasuredBlock>& Measured() const override { return measured_; }
  Status Run(const PhsParams& params, Span, Channels* out) const override {
    out->assign(1, {});
    for (int i = 0; i < kRivalRows; ++i) {
      out->front().push_back(params.friction.scale * std::sin(0.3 * i) +
                             1e3 * params.lines[0].oil_volume_m3 * std::cos(0.3 * i));
    }
    return {};
  }
  Status Uncertainty(const PhsParams&, Span, Channels* deviation) const override {
    deviation->assign(1, std::vector<double>(kRivalRows, 0.0));
    return {};
  }
  FreeModel Declared(const PhsParams& declared) const override { return {declared, {}}; }
  std::vector<Candidate> Candidates(const PhsParams&) const override { return {}; }
  std::shared_ptr<const ForwardModel> Coarse(double) const override { return nullptr; }
  std::shared_ptr<const ForwardModel> Driven(const rigs::RigMotion&, double) const override {
    return std::make_shared<const TwoWaves>(*this);
  }
  std::vector<MeasuredBlock> measured_;
};

FittedModel OneWave(const char* number, double value, double other) {
  PhsParams params = Declared();
  params.friction.scale = params.lines[0].oil_volume_m3 = other;
  return {number, {params, {{number, value, -10, 10, false, 1}}}, {value}};
}

TEST(TestEvidence, IsTheMeanAndScatterOfDrawnRecords) {
  const double noise = 1;
  const FittedModel sine = OneWave("friction.scale", 0.7, 0);
  FittedModel cosine = OneWave("L1.oil_volume_m3", 0, 0);
  cosine.model.free[0].low = -1e-2, cosine.model.free[0].high = 1e-2;
  cosine.model.free[0].scale = 1e-3;
  const auto model = std::make_shared<TwoWaves>(noise);
  RecordNoise of{1, {"load_cell_N"}, {noise}, {std::vector<double>(5, 1.0)}};
  const TestEvidence expected = Expect(model, 1, of, 1e9, sine, cosine, 4);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  double sum = 0, square = 0;
  constexpr int kDraws = 400;
  for (int k = 0; k < kDraws; ++k) {
    auto drawn = std::make_shared<TwoWaves>(noise);
    for (int i = 0; i < kRivalRows; ++i) {
      drawn->measured_[0].values[static_cast<size_t>(i)] =
          0.7 * std::sin(0.3 * i) + noise * normal(random);
    }
    const auto problem = FitProblem::Create(drawn, sine.model.params);
    const FitResult a = FitNear(problem.value(), sine.model, sine.values, {}, {});
    const FitResult b = FitNear(problem.value(), cosine.model, cosine.values, {}, {});
    ASSERT_TRUE(a.ok && b.ok);
    sum += b.score - a.score, square += (b.score - a.score) * (b.score - a.score);
  }
  const double mean = sum / kDraws, deviation = std::sqrt(square / kDraws - mean * mean);
  // The best of the random powers is a little better than their mean: a few of 2 ln L.
  EXPECT_NEAR(expected.expected, mean, 0.15 * mean);
  EXPECT_NEAR(expected.deviation, deviation, 0.3 * deviation);
}

TEST(TestEvidence, AModelThatHoldsTheTruthIsNotRuledOut) {
  const FittedModel sine = OneWave("friction.scale", 0.7, 0);
  FittedModel both = OneWave("L1.oil_volume_m3", 0, 0);
  both.model.free[0] = {"L1.oil_volume_m3", 0, -1e-2, 1e-2, false, 1e-3};
  both.model.free.push_back(sine.model.free[0]);
  both.values = {0, 0.2};
  RecordNoise of{1, {"load_cell_N"}, {1}, {std::vector<double>(5, 1.0)}};
  const TestEvidence e = Expect(std::make_shared<TwoWaves>(1), 1, of, 1e9, sine, both, 4);
  EXPECT_NEAR(e.expected, 0, 1e-3);
  EXPECT_LT(e.probability(), 0.5);
}

TEST(TestEvidence, AForceBeyondTheLimitSaysNothing) {
  const FittedModel sine = OneWave("friction.scale", 0.7, 0);
  RecordNoise of{1, {"load_cell_N"}, {1}, {std::vector<double>(5, 1.0)}};
  const TestEvidence e = Expect(std::make_shared<TwoWaves>(1), 1, of, 0.5, sine, sine, 1);
  EXPECT_LT(e.margin, -1e299);
}

TEST(TestMotion, EveryMotionStaysWithinTheLimits) {
  for (const auto& [low, high, speed] :
       {std::array{-2e-3, 3e-3, 0.02}, std::array{0.0, 1e-3, 0.002}, std::array{-5e-3, 0.0, 0.5}}) {
    const MotionLimits limits{low, high, speed, 60};
    const std::vector<TestMotion> family = ListTestMotions(limits, 6);
    EXPECT_GT(family.size(), 20u);
    for (size_t k = 0; k < family.size(); ++k) {
      const auto m = Sampled(Joined(family[k], family[family.size() - 1 - k]), limits, 0.005, 2);
      for (int c : {0, 1}) {
        const auto& x = m.position_m[static_cast<size_t>(c)];
        ASSERT_EQ(x.size(), 12000u) << family[k].text;
        EXPECT_GE(*std::min_element(x.begin(), x.end()), low - 1e-9) << family[k].text;
        EXPECT_LE(*std::max_element(x.begin(), x.end()), high + 1e-9) << family[k].text;
        for (size_t i = 1; i < x.size(); ++i) {
          ASSERT_LE(std::abs(x[i] - x[i - 1]) / 0.005, 1.01 * speed) << family[k].text;
        }
        EXPECT_EQ(x[0], 0) << family[k].text;
        EXPECT_EQ(x[500], 0) << "at rest for 3 s: " << family[k].text;
        EXPECT_NEAR(x.back(), 0, 1e-12) << family[k].text;
      }
    }
  }
}

/// What a search would have found: `one` accepted, `other` as good.
Identification Undecided(const FitProblem& problem, const PhsParams& declared, const char* one,
                         const char* other) {
  Identification found;
  found.declared = problem.forward().Declared(declared);
  const auto list = problem.forward().Candidates(declared);
  const auto pick = [&](const char* name) {
    return *std::find_if(list.begin(), list.end(),
                         [&](const Candidate& c) { return c.effect == name; });
  };
  AcceptedEffect effect{pick(one), {}, {other}};
  effect.rivals.push_back({pick(other), pick(other).starts.front()});
  found.corrected = WithCandidate(found.declared, effect.candidate);
  for (const auto& p : found.declared.free) found.after.values.push_back(p.start);
  for (const double v : effect.candidate.starts.front()) found.after.values.push_back(v);
  found.effects.push_back(effect);
  found.after = FitNear(problem, found.corrected, found.after.values, {}, {.final_slopes = true});
  return found;
}

TEST(NextTest, TellsALeakFromAHoseWhereASmallSineDoesNot) {
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(declared);
  const auto problem = ProblemOf(data, declared);
  ASSERT_TRUE(problem.ok());
  const Identification found =
      Undecided(problem.value(), declared, "external_leakage", "hose_expansion");
  TestRig rig = MakeTestRig({}, {"actuator_m"}, data.step_s, {data.motion[0].position},
                            {data.motion[0].speed}, {8e4}, 0.02);
  rig.coarse_step_s = 0.04;
  const auto questions = OpenQuestions(problem.value(), found);
  const auto test = DesignTest(problem.value(), found, questions, rig, 2, nullptr);
  ASSERT_TRUE(test);
  ASSERT_EQ(test->answers.size(), test->questions.size());
  EXPECT_EQ(test->questions[0].one.name, "external_leakage");
  EXPECT_EQ(test->questions[0].other.name, "hose_expansion");
  EXPECT_NE(rig.said.find("as in the record"), std::string::npos);
  const auto words = Sentences(*test, rig);
  EXPECT_NE(words[0].find("external_leakage against hose_expansion"), std::string::npos);
  EXPECT_NE(words[0].find("probability"), std::string::npos) << words[0];
  // No motion of the family says more.
  const RecordNoise noise = NoiseOf(problem.value(), found.after, rig.step_s);
  for (const TestMotion& other : ListTestMotions(rig.limits, 1)) {
    const auto driven =
        problem.value().forward().Driven(Sampled(other, rig.limits, rig.coarse_step_s, 1), 45);
    const Question& q = test->questions[0];
    const double margin =
        Expect(driven, rig.coarse_step_s, noise, rig.force_N, q.one, q.other, 6).margin;
    EXPECT_LT(margin, 1.2 * test->answers[0][0].margin + 20) << other.text;
  }
}

// Its seals alone hold with more than that: no motion is offered, not even the least of them.
TEST(NextTest, NoMotionIsOfferedBeyondTheForceOfTheRig) {
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(declared);
  const auto problem = ProblemOf(data, declared);
  const Identification found =
      Undecided(problem.value(), declared, "external_leakage", "hose_expansion");
  const auto questions = OpenQuestions(problem.value(), found);
  TestRig rig = MakeTestRig({}, {"actuator_m"}, data.step_s, {data.motion[0].position},
                            {data.motion[0].speed}, {300}, 0.02);
  rig.coarse_step_s = 0.04;
  EXPECT_FALSE(DesignTest(problem.value(), found, questions, rig, 2, nullptr));
}

TEST(NextTest, ANumberThatTheRecordLeavesOpenIsAQuestion) {
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(declared);
  const auto problem = ProblemOf(data, declared);
  Identification found;
  found.declared = found.corrected = problem.value().forward().Declared(declared);
  for (const auto& p : found.declared.free) found.after.values.push_back(p.start);
  found.after =
      FitNear(problem.value(), found.corrected, found.after.values, {}, {.final_slopes = true});
  EXPECT_TRUE(OpenQuestions(problem.value(), found).empty());
  found.after.half_95[0] = 10;
  const auto questions = OpenQuestions(problem.value(), found);
  ASSERT_EQ(questions.size(), 1u);
  EXPECT_TRUE(questions[0].number);
  EXPECT_EQ(questions[0].one.values.size() + 1, found.after.values.size());
}

}  // namespace
}  // namespace phs::identify::search
