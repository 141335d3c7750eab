// The results below a folder, each told in one line; and their reports drawn again.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "report/result_kinds.h"

namespace phs::report {

struct FoundResults {
  std::vector<ResultSummary> results = {};  ///< by folder
  std::vector<std::string> closed = {};     ///< folders that cannot be looked into
};

/// Every result below `root`, itself included. Links are not followed; folders of results being
/// written and hidden ones are left out.
FoundResults FindResults(const std::string& root);

/// Draws report.html of that folder again from what it holds; a run with its `replay`, if given.
Status RemakeReport(const std::string& folder, const MakeReplay& replay = {});

}  // namespace phs::report
