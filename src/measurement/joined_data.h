// Several measured runs of one kind of rig as one record, to be scored and looked at together.
//
// Its clock is made up: first the estimation windows of all runs, one after the other, then their
// validation windows; what lies in neither is left out. Column `run` says which run a sample is of.
#pragma once

#include <vector>

#include "measurement/fit_data.h"

namespace phs::measurement {

struct JoinedData {
  FitData data;
  /// [run][k]: sample of the run that is the k-th of its own in `data`, and where it stands there.
  struct Place {
    int sample = 0, joined = 0;
  };
  std::vector<std::vector<Place>> places;
  std::vector<std::vector<int>> outputs;  ///< [run][output of the run] -> output of `data`
};

/// A run may have one window only. Outputs are those of any run. Errors: clocks of different rate,
/// no window of one kind in any run.
Result<JoinedData> JoinData(const std::vector<FitData>& runs);

}  // namespace phs::measurement
