// Two effects that a user suspects: how large they may be, and the test that tells them apart.
#include "identify/select/test_question.h"

#include "identify/fit/near_fit.h"
#include "identify/next_test/next_test.h"
#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using hydraulics::PhsParams;

const char* const kLeak = "external_leakage";
const char* const kHose = "hose_expansion";

/// A record fitted by its declared model, nothing found.
Identification Plain(const FitProblem& problem, const PhsParams& declared) {
  Identification found;
  found.declared = found.corrected = problem.forward().Declared(declared);
  std::vector<double> start;
  for (const auto& p : found.declared.free) start.push_back(p.start);
  found.after =
      FitNear(problem, found.declared, start, {}, {.max_steps = 10, .final_slopes = true});
  return found;
}

PhsParams LeakingRig(double conductance) {
  PhsParams truth = Declared();
  truth.effects.push_back({kLeak, {"L1"}, {{"conductance_m3_per_Pas", conductance}}});
  return truth;
}

Result<Question> Ask(const FitProblem& problem, const PhsParams& declared) {
  const auto coarse = problem.Coarse(declared, 0.04);
  return AskedQuestion(problem, coarse.value(), Plain(problem, declared), {kLeak, kHose}, {});
}

TEST(TestQuestion, OfWhatARecordDoesNotShowTheLargestThatItLeavesOpenIsTaken) {
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(declared);
  const auto problem = ProblemOf(data, declared);
  const auto asked = Ask(problem.value(), declared);
  ASSERT_TRUE(asked.ok()) << asked.error().Line();
  const Question& q = asked.value();
  EXPECT_EQ(q.one.name, kLeak);
  EXPECT_EQ(q.other.name, kHose);
  for (const std::string& size : q.sizes)
    EXPECT_NE(size.find("leaves open"), std::string::npos) << size;
  // With that leak -2 ln L is 3.84 above the best, within the last halving of the way there.
  const size_t at = problem.value().forward().Declared(declared).free.size();
  const auto score = [&](double leak) {
    std::vector<double> others = q.one.values;
    others.erase(others.begin() + static_cast<long>(at));
    return FitNear(problem.value(), WithHeld(q.one.model, at, leak), others, {}, {.max_steps = 10})
        .score;
  };
  const double leak = q.one.values[at], none = q.one.model.free[at].low;
  ASSERT_GT(leak, 10 * none);
  EXPECT_LT(score(leak) - score(none), 4.5);
  EXPECT_GT(score(1.5 * leak) - score(none), 3.84);
}

TEST(TestQuestion, WhatARecordShowsIsTakenAsFitted) {
  const double conductance = 2e-15;
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(LeakingRig(conductance));
  const auto problem = ProblemOf(data, declared);
  const auto asked = Ask(problem.value(), declared);
  ASSERT_TRUE(asked.ok()) << asked.error().Line();
  EXPECT_NE(asked.value().sizes[0].find("as fitted"), std::string::npos) << asked.value().sizes[0];
  // Through an orifice (exponent 1/2) 1.5e-15 at 5 MPa leaks as much here: the record tells no exponent.
  const double fitted =
      asked.value().one.values[problem.value().forward().Declared(declared).free.size()];
  EXPECT_GT(fitted, 0.7 * conductance);
  EXPECT_LT(fitted, 1.1 * conductance);
}

TEST(TestQuestion, AnAskedTestIsDesignedForWhatWasAsked) {
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(declared);
  const auto problem = ProblemOf(data, declared);
  const auto asked = Ask(problem.value(), declared);
  ASSERT_TRUE(asked.ok());
  TestRig rig = MakeTestRig({}, {"actuator_m"}, data.step_s, {data.motion[0].position},
                            {data.motion[0].speed}, {8e4}, 0.02);
  rig.coarse_step_s = 0.04;
  const auto test = DesignTest(problem.value(), Plain(problem.value(), declared), {asked.value()},
                               rig, 2, nullptr);
  ASSERT_TRUE(test);
  const auto text = Sentences(*test, rig).front();
  EXPECT_NE(text.find("external_leakage against hose_expansion"), std::string::npos) << text;
  EXPECT_NE(text.find("leaves open"), std::string::npos) << text;
  const auto json = ToJson(*test, rig);
  EXPECT_TRUE(json["questions"][0]["if_true"][1]["size"].is_string());
}

TEST(TestQuestion, AStopIsHeardBeforeTheNextFit) {
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(declared);
  const auto problem = ProblemOf(data, declared);
  const auto coarse = problem.value().Coarse(declared, 0.04);
  for (const int heard : {0, 3}) {  // before the first candidate, and among their fits
    int asked = 0;
    const auto stopped =
        AskedQuestion(problem.value(), coarse.value(), Plain(problem.value(), declared),
                      {kLeak, kHose}, {.threads = 2}, [&] { return ++asked <= heard; });
    EXPECT_FALSE(stopped.ok()) << "nothing was fitted to the end";
    EXPECT_GT(asked, heard);
  }
}

TEST(TestQuestion, OnlyTwoDifferentEffectsThatAreTriedCanBeAskedFor) {
  const PhsParams declared = Declared();
  const measurement::FitData data = Record(declared);
  const auto problem = ProblemOf(data, declared);
  const ForwardModel& forward = problem.value().forward();
  EXPECT_TRUE(CheckBetween(forward, declared, {}).ok());
  EXPECT_TRUE(CheckBetween(forward, declared, {kLeak, kHose}).ok());
  for (const std::vector<std::string>& names :
       std::vector<std::vector<std::string>>{{kLeak}, {kLeak, kLeak}, {kLeak, "leak"}}) {
    const Status s = CheckBetween(forward, declared, names);
    ASSERT_FALSE(s.ok());
    EXPECT_NE(s.error().Line().find(kHose), std::string::npos) << "names what is allowed";
  }
  EXPECT_FALSE(CheckBetween(forward, LeakingRig(1e-12), {kLeak, kHose}).ok()) << "declared already";
}

}  // namespace
}  // namespace phs::identify::search
