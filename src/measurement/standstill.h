// Where a driven part stands still, from its smoothed motion or its samples.
#pragma once

#include <vector>

#include "measurement/motion_smoother.h"

namespace phs::measurement {

/// Samples at rest: |speed| within `widths` of its deviation, or below `slowest_m_s`, for at least
/// `shortest_s`.
std::vector<char> FindRest(const SmoothMotion& motion, double step_s, double widths,
                           double slowest_m_s, double shortest_s);

/// Samples in stretches of 1 s over which the measured motion shows neither trend (4 standard
/// deviations of its slope) nor more than `noise` (twice its variance): a creeping piston, which
/// FindRest takes for one at rest, changes the force on its load cell by far more than noise.
std::vector<char> FindStandstill(const std::vector<double>& samples, const std::vector<char>& bad,
                                 double step_s, double noise);

}  // namespace phs::measurement
