// The report of a curving run: one bogie, or several side by side on the same track.
//
// It is made from saved results only, so it can be made again at any time without simulating:
//   auto input = CurvingReportInput::FromDirectory("results/r550");
//   WriteCurvingReport(input.value(), "results/r550/report.html");
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "report/curving_input.h"
#include "report/replay.h"

namespace phs::report {

/// Writes the page. Channels that a run does not have are left out. `replay` (src/film) is shown in
/// it; null: a page without one.
Status WriteCurvingReport(const CurvingReportInput& input, const std::string& path,
                          const Replay* replay = nullptr);
/// The same from the files found in a result directory.
Status WriteCurvingReport(const std::string& directory, const std::string& path,
                          const Replay* replay = nullptr);

}  // namespace phs::report
