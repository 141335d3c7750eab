// The motion as it might have been measured: the smoothed one with fresh noise of the sensor,
// smoothed again. What a model makes of several of them tells what of its output the measured
// motion leaves uncertain (parametric bootstrap: Efron and Tibshirani 1993, ch. 6): a stiff bristle
// turns a micrometre into a hundred newtons where the piston rests, and into nothing where it
// slides.
#pragma once

#include <mutex>
#include <vector>

#include "measurement/fit_data.h"

namespace phs::measurement {

class RedrawnMotion {
 public:
  static constexpr int kDraws = 4;
  /// `data` must outlive it.
  explicit RedrawnMotion(const FitData& data) : data_(data) {}
  /// [draw][actuator] over the whole record, position and speed alone; drawn when first asked for,
  /// always the same.
  const std::vector<std::vector<SmoothMotion>>& Draws();

 private:
  const FitData& data_;
  std::once_flag drawn_;
  std::vector<std::vector<SmoothMotion>> draws_;
};

/// Root mean square over draws of `with` - `without`, and over `reach_s` to either side of each
/// sample: a few draws tell a mean, not the deviation of one sample.
std::vector<double> DeviationOfDraws(const std::vector<std::vector<double>>& with,
                                     const std::vector<double>& without, double step_s,
                                     double reach_s);

}  // namespace phs::measurement
