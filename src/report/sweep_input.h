// The table that a page of a sweep is made from.
#pragma once

#include <string>
#include <vector>

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

}  // namespace phs::report
