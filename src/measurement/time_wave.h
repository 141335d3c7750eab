// The strongest wave in a record: Fourier transform of the evenly sampled record, padded with
// zeros to at least four times its length, then a finer search about the highest line.
#pragma once

#include <vector>

namespace phs::measurement {

struct TimeWave {
  double frequency_Hz = 0;  ///< 0: none; the record is too short
  double looked_at = 1;     ///< so many frequencies could have been told apart
};

/// `weighted`: value times weight, 0 where nothing was measured; `step_s` between samples. Looked
/// for between `least_periods` in the record and 0.45 of the sampling frequency.
TimeWave FindTimeWave(const std::vector<double>& weighted, double step_s,
                      double least_periods = 1.5);

}  // namespace phs::measurement
