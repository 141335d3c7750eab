// The reports of `phs identify` and `phs rig`: measured against predicted, what was found, what is
// left. Made from saved files only.
//
// result.json is read as documented for the identification; beyond it, where present:
//   "estimation": [t0, t1], "validation": [t0, t1]   windows [s], shaded in the plots
//   "channels_estimation": like "channels", scored on the estimation window
//   "next_test": "…" or ["…"]                         advice of the identification itself
//   "data_findings": [{"channel": …, "text": …}]      faults of the data, found and mended
//   "declared": "…", "data": "…"                      names for the subtitle
// Entries of "candidates" may hold any numbers and texts; each becomes a column of the table.
// A rig run has {"channels": {NAME: {"rmse": …, …}}} without "before" and "after".
#pragma once

#include <string>

#include "base/result.h"
#include "report/identify_input.h"

namespace phs::report {

/// Writes the page. Plots need `measured` and `predicted`; without them the tables remain.
Status WriteIdentifyReport(const IdentifyReportInput& input, const std::string& path);

}  // namespace phs::report
