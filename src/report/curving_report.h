// The report of a curving run: one bogie, or several side by side on the same track.
//
// It is made from saved results only, so it can be made again at any time without simulating:
//   auto input = CurvingReportInput::FromDirectory("results/r550");
//   WriteCurvingReport(input.value(), "results/r550/report.html");
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::report {

/// The files a curving report is made from.
struct CurvingReportInput {
  std::string results;  ///< compare.json, or summary.json of a single run
  struct Run {
    std::string bogie;   ///< as named in the results
    std::string series;  ///< HDF5 time series (base/hdf5_series.h); empty = tables only
  };
  std::vector<Run> runs;  ///< in the order of the report; the first is the one compared with

  /// Finds the files of a result directory: compare.json or summary.json, and of each bogie
  /// `NAME_timeseries.h5` or `NAME/timeseries.h5`; for a single run `timeseries.h5`.
  static Result<CurvingReportInput> FromDirectory(const std::string& directory);
};

/// Writes the page. Channels that a run does not have are left out.
Status WriteCurvingReport(const CurvingReportInput& input, const std::string& path);
/// The same from the files found in a result directory.
Status WriteCurvingReport(const std::string& directory, const std::string& path);

}  // namespace phs::report
