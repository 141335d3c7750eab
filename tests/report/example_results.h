// Result directories of made-up curving runs for the tests of the report: the files and channels of
// a real run, filled from simple laws of the curvature (no simulation, no claim about any bogie).
#pragma once

#include <string>
#include <vector>

namespace phs::report::testing {

struct ExampleOptions {
  std::vector<std::string> bogies = {"phs", "rigid_link", "soft_link"};
  int hand = 1;              ///< +1 curve to the left, -1 to the right
  bool locomotive = false;   ///< channels with front_ and rear_
  bool derailed = false;     ///< the last bogie's run stops in the curve
  bool single = false;       ///< summary.json of the first bogie instead of compare.json
  bool series = true;        ///< write time series
  double interval_m = 0.08;  ///< distance between rows
};

/// Fills an existing directory.
void WriteExampleResults(const std::string& directory, const ExampleOptions& options);

/// Fills an existing directory with result.json, measured.csv, predicted.csv and baseline.csv of a
/// made-up identification.
void WriteExampleIdentification(const std::string& directory);

}  // namespace phs::report::testing
