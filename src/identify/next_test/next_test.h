// The test that would tell: what to measure next, where a record does not decide.
//
// Of the motions that the rig can make (test_motion.h) the one is taken whose least expected evidence
// (test_evidence.h), over all questions (test_question.h) and over which of the two is true, is
// greatest. All motions are looked at on a coarse clock with one step of the
// refit; the best four, and their pairs one after the other, again; the best three of all on the
// clock of the record with six steps.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result_dir.h"
#include "identify/next_test/test_motion.h"
#include "identify/result/unexplained.h"
#include "identify/select/effect_search.h"
#include "identify/select/test_question.h"
#include "measurement/manifest.h"

namespace phs::identify::search {

/// The rig as its record shows it, and as the manifest limits it.
struct TestRig {
  std::vector<std::string> inputs;  ///< driven channels
  double step_s = 0;                ///< of the record
  double coarse_step_s = 0;         ///< for looking around
  MotionLimits limits;
  double force_N = 0;  ///< most that a force channel may show
  std::string said;    ///< the limits, and where they come from
};
/// `positions`, `speeds`: of the driven channels in the record; `stop_m`: the model's own end stop.
TestRig MakeTestRig(const measurement::TestLimits& asked, std::vector<std::string> inputs,
                    double step_s, const Channels& positions, const Channels& speeds,
                    const std::vector<double>& forces, double stop_m);

struct NextTest {
  std::vector<Question> questions;
  TestMotion motion;
  std::vector<std::array<TestEvidence, 2>> answers;  ///< [question][which is true]
  double margin = -1e300;                            ///< the least of them
};

/// Nothing where there is no question, or what drives the model cannot be chosen. `go_on`: asked
/// before each motion, false = stop.
std::optional<NextTest> DesignTest(const FitProblem& problem, const Identification& found,
                                   const std::vector<Question>& questions, const TestRig& rig,
                                   int threads, const std::function<bool()>& go_on);

/// A sentence where the validation window excites what the estimation window does not, else empty.
std::string OtherMotion(const Unexplained& left);

/// Designs a test for the effects of `options.between` or, where none are named, for what the record
/// leaves open; `next_test` of `result` gets what it says, `test_design` its numbers, the result
/// folder next_test.csv. OtherMotion is said there too.
Status PutNextTest(const FitProblem& problem, const Identification& found, const Unexplained& left,
                   const TestRig& rig, const SearchOptions& options,
                   const std::function<bool()>& go_on, const ResultDir& dir,
                   nlohmann::ordered_json* result);

/// `next_test` where the data contradict themselves: no motion mends that.
Status PutRecordFirst(nlohmann::ordered_json* result);

/// next_test.csv in the result folder.
Status WriteNextTest(const NextTest& test, const TestRig& rig, const ResultDir& dir);
/// `test_design` of result.json.
nlohmann::ordered_json ToJson(const NextTest& test, const TestRig& rig);
/// A sentence for each question.
std::vector<std::string> Sentences(const NextTest& test, const TestRig& rig);

}  // namespace phs::identify::search
