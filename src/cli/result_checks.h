// --check and --junit of every verb that yields numbers: its result held against a file of limits
// (docs/checks.md), and how it did as JUnit XML.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/limits.h"
#include "base/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace phs::cli {

class ResultChecks {
 public:
  /// Adds both options to a verb. This object must stay where it is until the verb has run.
  void AddOptions(CLI::App* verb);
  /// True if one of them was given.
  bool asked() const { return !limits_file_.empty() || !junit_.empty(); }

  /// Reads the limits: before any long work, so that a wrong file ends it at once.
  Status Read();
  /// Says on stderr what failed and writes the XML. `results`: name of what was calculated (a bogie,
  /// a run) and its numbers; a `status` there that is not "ok" fails. Without limits that is
  /// all. Returns the exit code: `code` where all is kept.
  int Conclude(const std::string& suite, std::vector<analysis::NamedSummary> results, int code,
               const nlohmann::ordered_json& ratios = nullptr) const;

 private:
  std::string limits_file_;
  std::string junit_;
  std::vector<analysis::Limit> limits_;
};

}  // namespace phs::cli
