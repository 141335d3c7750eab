// The kinds of results, one row each: by which file a kind is known, how it is told in a line, how
// its page is drawn again.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "base/result.h"
#include "report/replay.h"

namespace phs::report {

/// What a result folder holds, in one line of the index.
struct ResultSummary {
  std::string folder = {};   ///< relative to where the search began, "." for itself
  std::string kind = {};     ///< "Comparison", "Identification" …
  std::string status = {};   ///< "ok", "derailed", a verdict
  bool bad = false;          ///< the status says that something is wrong
  std::string numbers = {};  ///< headline
  std::string report = {};   ///< relative to where the search began; empty = none
  std::string date = {};     ///< from origin.json, else that of the main file: "…, file"
};

struct ResultKind {
  const char* file;
  const char* member;  ///< that this file has; another program's file of the same name has not
  const char* kind;
  void (*tell)(const nlohmann::ordered_json&, ResultSummary*);  ///< may throw a JSON exception
  /// Null: it has no page.
  Status (*remake)(const std::string& folder, const MakeReplay& replay);
};
std::span<const ResultKind> ResultKinds();

/// A sweep is known by its table; what its page needs besides stands in another file
/// (sweep_report.h).
inline constexpr char kSweepTable[] = "sweep.csv";
void TellSweep(const std::string& table, ResultSummary* told);

}  // namespace phs::report
