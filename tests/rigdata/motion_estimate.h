// Position and speed of the actuator from its noisy samples, for driving a model with measured
// motion: local quadratic fits over windows whose width adapts to the data. The widest window is
// taken whose estimate still agrees with all narrower ones (intersection of confidence intervals,
// Goldenshluger and Nemirovski 1997).
#pragma once

#include <vector>

#include "rig_truth.h"

namespace rigdata {

struct MotionEstimate {
  double rate = 200;         // Hz
  std::vector<double> x, v;  // m, m/s
  // Makes the positions follow the speeds: the integral of v, drawn to x over `time` seconds from
  // both sides. For models whose piston speed comes out of the position.
  void MakeConsistent(double time);
  ActuatorInput Input() const;  // cubic Hermite position, linear speed; refers to this object
};

// `noise`: standard deviation of the samples, m. `confidence`: half width of the intervals in
// standard deviations.
MotionEstimate EstimateMotion(const std::vector<double>& samples, double rate, double noise,
                              double confidence);

}  // namespace rigdata
