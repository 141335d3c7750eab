// The report of a parameter sweep: results over the varied parameters.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::report {

struct SweepReportInput {
  std::string table = {};                    ///< CSV, one row per run; names carry their units
  std::vector<std::string> parameters = {};  ///< numeric columns that were varied, main one first
  std::vector<std::string> outputs = {};     ///< numeric columns to show
};

/// Writes the page: for each output one plot over the first parameter with a curve for each
/// combination of texts (bogie) and further parameters; with exactly two numeric parameters also a
/// map. Runs whose `status` is not ok are listed and left out of the plots.
/// Without `parameters` those columns left of `status` are taken that hold more than one number;
/// without `outputs` the numeric columns right of it.
Status WriteSweepReport(const SweepReportInput& input, const std::string& path);

}  // namespace phs::report
