// The report of a parameter sweep: results over the varied parameters.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "report/sweep_input.h"

namespace phs::report {

/// Writes the page: for each output one plot over the first parameter with a curve for each
/// combination of texts (bogie) and further parameters; with exactly two numeric parameters also a
/// map; samples as points, with rank correlations and Sobol indices. The worst cases with the
/// command that repeats each. Runs whose `status` is not ok are listed and left out of the plots.
/// Without `parameters` those columns left of `status` are taken that hold more than one number;
/// without `outputs` the numeric columns right of it.
Status WriteSweepReport(const SweepReportInput& input, const std::string& path);

/// What the page needs beside the table: kept with the result, so that the page can be drawn again.
inline constexpr char kSweepReportInput[] = "sweep_report.json";
/// Writes it into the folder of `input.table`.
Status KeepSweepReportInput(const SweepReportInput& input);
/// Draws the page of a finished sweep's folder again from its table and what was kept with it.
Status RemakeSweepReport(const std::string& folder);

}  // namespace phs::report
