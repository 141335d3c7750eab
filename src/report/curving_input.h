// The files that a page of curving is made from.
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

}  // namespace phs::report
