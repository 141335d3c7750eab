// Judges what an identification said about data sets whose truth is known.
//
// Per set, from the truth and the program's result.json:
//   first right   the strongest accepted effect is one that is hidden
//   exact         the accepted names are the hidden names, no more and no less
//   complete      every hidden name is accepted (others may be there too)
//   false alarm   something is accepted although nothing is hidden
//   error ratio   √ mean over channels of (RMSE after / RMSE of the true model)², validation window
// An effect that is not on the list counts as described when an `unlisted` effect is accepted and
// as bent when a listed one is.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace rigdata {

struct SetScore {
  std::string set, kind;
  std::vector<std::string> hidden;  // names, with "(weak)" kept apart below
  std::vector<std::string> grades;
  std::vector<std::string> accepted;    // strongest first
  std::vector<std::string> confusable;  // with the first accepted effect
  bool answered = false;                // the program ended well and its result could be read
  std::string problem;                  // why not
  double error_ratio = 0, declared_ratio = 0, strict_ratio = 0;
  double seconds = 0, megabytes = 0;

  bool FirstRight() const;
  bool Exact() const;
  bool Complete() const;
  bool FalseAlarm() const;
  bool Described() const;
  bool Bent() const;
};

// `result` may lack what it likes: then `answered` is false and `problem` says why.
SetScore JudgeSet(const std::string& set, const std::string& kind, const nlohmann::json& truth,
                  const nlohmann::json& result);

struct Threshold {
  std::string what;
  int good = 0, of = 0;  // a share, or
  double value = 0;      // a plain number when `of` is 0
  double limit = 0;
  bool at_most = false;
  bool measured = true;  // there was something to measure
  double Value() const { return of > 0 ? static_cast<double>(good) / of : value; }
  bool Passed() const;
};

// Exact 95 % interval of a share (Clopper and Pearson 1934), `good` of `of` > 0.
std::array<double, 2> ShareInterval(int good, int of);

struct SuiteScore {
  std::vector<SetScore> sets;
  std::vector<Threshold> thresholds;
  bool Passed() const;
};

SuiteScore JudgeSuite(std::vector<SetScore> sets);

// Summary, one line per hidden effect, and every set.
std::string ScoreMarkdown(const SuiteScore& score, const std::string& title);

}  // namespace rigdata
