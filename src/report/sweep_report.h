// The report of a parameter sweep: results over the varied parameters.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::report {

/// Sobol indices of one output, one number per parameter of the input.
struct OutputIndices {
  std::string output = {};
  std::vector<double> first = {}, total = {};
  std::vector<double> first_error = {}, total_error = {};  ///< standard errors
};

struct SweepReportInput {
  std::string table = {};                    ///< CSV, one row per run; names carry their units
  std::vector<std::string> parameters = {};  ///< numeric columns that were varied, main one first
  std::vector<std::string> outputs = {};     ///< numeric columns to show
  bool sampled = false;  ///< values at random: points over the parameter that matters most
  std::vector<OutputIndices> indices = {};
  std::string study = {};  ///< for the command that repeats a run
};

/// Writes the page: for each output one plot over the first parameter with a curve for each
/// combination of texts (bogie) and further parameters; with exactly two numeric parameters also a
/// map; samples as points, with rank correlations and Sobol indices. The worst cases with the
/// command that repeats each. Runs whose `status` is not ok are listed and left out of the plots.
/// Without `parameters` those columns left of `status` are taken that hold more than one number;
/// without `outputs` the numeric columns right of it.
Status WriteSweepReport(const SweepReportInput& input, const std::string& path);

}  // namespace phs::report
