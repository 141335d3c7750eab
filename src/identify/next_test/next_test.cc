#include "identify/next_test/next_test.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "base/table.h"
#include "base/words.h"

namespace phs::identify::search {
namespace {

constexpr double kFitted = 0.75;  // of a test: its estimation window

bool IsBetter(const NextTest& a, const NextTest& b) { return a.margin > b.margin; }

/// Of two driven cylinders: alike, and against each other.
std::vector<TestMotion> FamilyFor(const TestRig& rig) {
  std::vector<TestMotion> family = ListTestMotions(rig.limits, 0.125 / rig.coarse_step_s);
  const size_t alike = rig.inputs.size() > 1 ? family.size() : 0;
  for (size_t k = 0; k < alike; ++k) {
    family.push_back(family[k]);
    family.back().opposed = true, family.back().text += ", against each other";
  }
  return family;
}

/// Every motion on its own thread; those that cannot be run or borne keep their margin.
class Designer {
 public:
  Designer(const FitProblem& problem, const TestRig& rig, const RecordNoise& noise,
           const std::vector<Question>& questions, ThreadBudget* threads,
           const std::function<bool()>& go_on)
      : problem_(problem),
        rig_(rig),
        noise_(noise),
        questions_(questions),
        threads_(*threads),
        go_on_(go_on) {}

  /// The best `most` of these motions.
  std::vector<NextTest> Best(const std::vector<TestMotion>& motions, double step_s, int steps,
                             size_t most) {
    std::vector<NextTest> tests(motions.size());
    threads_.ForEach(static_cast<int>(motions.size()), [&](int k) {
      NextTest& test = tests[static_cast<size_t>(k)];
      test.motion = motions[static_cast<size_t>(k)];
      if (GoOn()) Ask(step_s, steps, &test);
    });
    std::stable_sort(tests.begin(), tests.end(), IsBetter);
    if (tests.size() > most) tests.resize(most);
    return tests;
  }

 private:
  bool GoOn() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return !go_on_ || go_on_();
  }

  void Ask(double step_s, int steps, NextTest* test) const {
    const auto samples =
        Sampled(test->motion, rig_.limits, step_s, static_cast<int>(rig_.inputs.size()));
    const auto driven = problem_.forward().Driven(samples, kFitted * rig_.limits.duration_s);
    if (driven == nullptr) return;
    double least = 1e300;
    for (const Question& q : questions_) {
      test->answers.push_back(
          {Expect(driven, step_s, noise_, rig_.force_N, q.one, q.other, steps),
           Expect(driven, step_s, noise_, rig_.force_N, q.other, q.one, steps)});
      for (const TestEvidence& e : test->answers.back()) least = std::min(least, e.margin);
    }
    test->margin = least;
  }

  const FitProblem& problem_;
  const TestRig& rig_;
  const RecordNoise& noise_;
  const std::vector<Question>& questions_;
  ThreadBudget& threads_;
  const std::function<bool()>& go_on_;
  std::mutex mutex_;
};

std::string Subject(const Question& q) {
  return q.number ? q.one.name + " or " + q.other.name.substr(q.other.name.rfind('=') + 2)
                  : q.one.name + " against " + q.other.name;
}

bool IsDrivable(const FitProblem& problem, const TestRig& rig) {
  const MotionLimits& l = rig.limits;
  if (!(l.high_m > l.low_m) || !(l.speed_m_s > 0) || rig.inputs.empty()) return false;
  const auto still = Sampled({}, l, l.duration_s / 4, static_cast<int>(rig.inputs.size()));
  return problem.forward().Driven(still, l.duration_s) != nullptr;
}

/// What was asked for, else what the record leaves open. `why_not`: of what was asked for.
std::vector<Question> QuestionsOf(const FitProblem& problem, const Identification& found,
                                  const TestRig& rig, const SearchOptions& options,
                                  const std::function<bool()>& go_on, std::string* why_not) {
  const bool drivable = IsDrivable(problem, rig);
  if (options.between.empty()) {
    return drivable ? OpenQuestions(problem, found) : std::vector<Question>();
  }
  const auto coarse = problem.Coarse(found.declared.params, rig.coarse_step_s);
  const Result<Question> asked =
      !drivable ? Error{"", "what drives this model is not chosen here", "", ""}
      : coarse.ok()
          ? AskedQuestion(problem, coarse.value(), found, options.between, options.effort, go_on)
          : Result<Question>(coarse.error());
  if (asked.ok()) return {asked.value()};
  *why_not = JoinWords(options.between) + ": no motion could be designed; " + asked.error().where +
             " " + asked.error().what;
  return {};
}

double Least(const std::array<TestEvidence, 2>& answers) {
  return std::min(answers[0].probability(), answers[1].probability());
}

}  // namespace

std::string OtherMotion(const Unexplained& left) {
  constexpr double kMuch = 2;  // times as much as in estimation, and as noise
  const double before = left.estimation_over_noise.value_or(left.over_noise);
  if (!(left.over_noise > kMuch) || !(left.over_noise > kMuch * before)) return {};
  return fmt::format(
      "the validation window excites what the estimation window does not: {} is {:.1f} times its "
      "noise there and {:.1f} times in estimation; identify again with such motion in both",
      left.channel, left.over_noise, before);
}

Status PutRecordFirst(nlohmann::ordered_json* result) {
  (*result)["next_test"] = {"mend the record first, as the reasons say, and identify it again"};
  return {};
}

Status PutNextTest(const FitProblem& problem, const Identification& found, const Unexplained& left,
                   const TestRig& rig, const SearchOptions& options,
                   const std::function<bool()>& go_on, const ResultDir& dir,
                   nlohmann::ordered_json* result) {
  nlohmann::ordered_json tests = nlohmann::ordered_json::array();
  const std::string other = OtherMotion(left);
  if (!other.empty()) tests.push_back(other);
  std::string why_not;
  const std::vector<Question> questions =
      QuestionsOf(problem, found, rig, options, go_on, &why_not);
  if (!why_not.empty()) tests.push_back(why_not);
  const std::optional<NextTest> test =
      DesignTest(problem, found, questions, rig, options.effort.threads, go_on);
  if (test) {
    for (const std::string& text : Sentences(*test, rig)) tests.push_back(text);
    (*result)["test_design"] = ToJson(*test, rig);
    if (Status s = WriteNextTest(*test, rig, dir); !s.ok()) return s;
  }
  const std::string none =
      ": no motion could be designed; " +
      (IsDrivable(problem, rig) ? "every one asks more of the rig than it may (" + rig.said + ")"
                                : "what drives this model is not chosen here");
  if (!test && !options.between.empty() && !questions.empty()) {
    tests.push_back(JoinWords(options.between) + none);
  }
  for (const AcceptedEffect& effect : found.effects) {
    if (test || effect.confusable_with.empty()) continue;
    tests.push_back(NameBesideRivals(effect) + " against " + JoinWords(effect.confusable_with) +
                    none);
  }
  (*result)["next_test"] = tests;
  return {};
}

TestRig MakeTestRig(const measurement::TestLimits& asked, std::vector<std::string> inputs,
                    double step_s, const Channels& positions, const Channels& speeds,
                    const std::vector<double>& forces, double stop_m) {
  TestRig rig;
  rig.inputs = std::move(inputs);
  rig.step_s = rig.coarse_step_s = step_s;
  MotionLimits& l = rig.limits;
  for (const auto& row : positions) {
    for (const double x : row) l.low_m = std::min(l.low_m, x), l.high_m = std::max(l.high_m, x);
  }
  for (const auto& row : speeds) {
    for (const double v : row) l.speed_m_s = std::max(l.speed_m_s, std::abs(v));
  }
  for (const double f : forces) {
    if (std::isfinite(f)) rig.force_N = std::max(rig.force_N, std::abs(f));
  }
  const auto from = [](bool said) { return said ? "" : ", as in the record"; };
  if (!asked.stroke_m.empty()) l.low_m = asked.stroke_m.begin, l.high_m = asked.stroke_m.end;
  l.low_m = std::max(l.low_m, -stop_m), l.high_m = std::min(l.high_m, stop_m);
  if (asked.speed_m_s > 0) l.speed_m_s = asked.speed_m_s;
  if (asked.force_N > 0) rig.force_N = asked.force_N;
  if (asked.duration_s > 0) l.duration_s = asked.duration_s;
  rig.said = fmt::format(
      "stroke {:.3g} to {:.3g} mm{}; speed {:.3g} mm/s{}; force {:.3g} kN{}; "
      "{:.3g} s{}",
      1e3 * l.low_m, 1e3 * l.high_m, from(!asked.stroke_m.empty()), 1e3 * l.speed_m_s,
      from(asked.speed_m_s > 0), 1e-3 * rig.force_N, from(asked.force_N > 0), l.duration_s,
      asked.duration_s > 0 ? "" : ", the usual length");
  return rig;
}

std::optional<NextTest> DesignTest(const FitProblem& problem, const Identification& found,
                                   const std::vector<Question>& questions, const TestRig& rig,
                                   int threads, const std::function<bool()>& go_on) {
  constexpr size_t kJoined = 4, kRefined = 3;
  if (questions.empty() || !IsDrivable(problem, rig)) return {};
  const RecordNoise noise = NoiseOf(problem, found.after, rig.step_s);
  ThreadBudget budget(threads);
  Designer designer(problem, rig, noise, questions, &budget, go_on);
  const std::vector<TestMotion> family = FamilyFor(rig);
  std::vector<NextTest> best = designer.Best(family, rig.coarse_step_s, 1, kJoined);
  std::vector<TestMotion> joined;
  for (size_t a = 0; a < best.size(); ++a) {
    for (size_t b = a + 1; b < best.size(); ++b) {
      if (best[a].motion.opposed != best[b].motion.opposed) continue;
      joined.push_back(Joined(best[a].motion, best[b].motion));
    }
  }
  for (NextTest& test : designer.Best(joined, rig.coarse_step_s, 1, kRefined)) {
    best.push_back(std::move(test));
  }
  std::stable_sort(best.begin(), best.end(), IsBetter);
  std::vector<TestMotion> refined;
  for (size_t k = 0; k < std::min(kRefined, best.size()); ++k) refined.push_back(best[k].motion);
  best = designer.Best(refined, rig.step_s, 6, 1);
  // What the rig cannot bear keeps the margin that it began with, however little force is allowed.
  if (best.empty() || best.front().answers.empty() || best.front().margin <= NextTest().margin)
    return {};
  best.front().questions = questions;
  return std::move(best.front());
}

Status WriteNextTest(const NextTest& test, const TestRig& rig, const ResultDir& dir) {
  const auto motion =
      Sampled(test.motion, rig.limits, rig.step_s, static_cast<int>(rig.inputs.size()));
  std::vector<std::string> names = {"t_s"};
  Channels columns(1);
  for (int i = 0; i < motion.num_samples(); ++i) columns[0].push_back(i * rig.step_s);
  for (size_t c = 0; c < rig.inputs.size(); ++c) {
    names.push_back(rig.inputs[c]), columns.push_back(motion.position_m[c]);
  }
  return WriteCsv(dir.File("next_test.csv"), names, columns);
}

nlohmann::ordered_json ToJson(const NextTest& test, const TestRig& rig) {
  nlohmann::ordered_json questions = nlohmann::ordered_json::array();
  for (size_t i = 0; i < test.questions.size(); ++i) {
    const Question& q = test.questions[i];
    nlohmann::ordered_json entry = {{"between", {q.one.name, q.other.name}}};
    for (size_t k = 0; k < 2; ++k) {
      const TestEvidence& e = test.answers[i][k];
      entry["if_true"].push_back({{"name", k == 0 ? q.one.name : q.other.name},
                                  {"log_likelihood_ratio", 0.5 * e.expected},
                                  {"probability_right", e.probability()}});
      if (!q.sizes.empty()) entry["if_true"].back()["size"] = q.sizes[k];
    }
    questions.push_back(std::move(entry));
  }
  return {{"file", "next_test.csv"},
          {"motion", test.motion.text},
          {"duration_s", rig.limits.duration_s},
          {"estimation", {0.0, kFitted * rig.limits.duration_s}},
          {"validation", {kFitted * rig.limits.duration_s, rig.limits.duration_s}},
          {"limits", rig.said},
          {"questions", questions}};
}

std::vector<std::string> Sentences(const NextTest& test, const TestRig& rig) {
  std::vector<std::string> out;
  for (size_t i = 0; i < test.questions.size(); ++i) {
    const auto& [if_one, if_other] = test.answers[i];
    const double sure = Least(test.answers[i]);
    std::string text = Subject(test.questions[i]) + ": ";
    for (const std::string& size : test.questions[i].sizes) text += size + "; ";
    text += sure < 0.5 ? "no motion within the limits tells; the best is next_test.csv"
                       : "measure next_test.csv";
    text += fmt::format(
        " ({}). Expected log likelihood ratio {:.0f} if the first is true, {:.0f} "
        "if the second; the right one is then told with a probability of {:.0f} %, "
        "under the noise of this record. Limits: {}.",
        test.motion.text, 0.5 * if_one.expected, 0.5 * if_other.expected, 100 * sure, rig.said);
    out.push_back(std::move(text));
  }
  return out;
}

}  // namespace phs::identify::search
