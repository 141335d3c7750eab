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

}  // namespace phs::report
