// Position and speed of a driven part from noisy samples, without lag.
//
// Kalman filter and Rauch-Tung-Striebel smoother (AIAA Journal 3 (1965) 1445) of position, speed
// and acceleration driven by white jerk. How lively the motion is, the strength q(t) of the jerk,
// comes from the data: a bank of filters with strengths over sixteen decades is run, and at every
// instant the one is taken that predicts the samples around it best (likelihood over about 0.2 s).
// Where the part rests, q is tiny and the speed settles at zero within its small uncertainty, so
// that the sign of friction does not flicker; at reversals and steps it is large and nothing is
// rounded off. Position and speed belong to one motion: differences of positions follow the speeds.
#pragma once

#include <vector>

namespace phs::identify {

struct SmoothMotion {
  std::vector<double> position;            ///< [m]
  std::vector<double> speed;               ///< [m/s]
  std::vector<double> acceleration;        ///< [m/s2]
  std::vector<double> position_deviation;  ///< standard deviation of the estimate [m]
  std::vector<double> speed_deviation;     ///< [m/s]
};

/// `noise`: standard deviation of the samples [m], > 0, taken as white. `bad` (empty or one flag a
/// sample): samples that are not believed. `step_s` > 0.
SmoothMotion SmoothPosition(const std::vector<double>& samples, const std::vector<char>& bad,
                            double step_s, double noise);

/// Samples at rest: |speed| within `widths` of its deviation, or below `slowest_m_s`, for at least
/// `shortest_s`.
std::vector<char> FindRest(const SmoothMotion& motion, double step_s, double widths,
                           double slowest_m_s, double shortest_s);

/// Samples in stretches of 1 s over which the measured motion shows neither trend (4 standard
/// deviations of its slope) nor more than `noise` (twice its variance): a creeping piston, which
/// FindRest takes for one at rest, changes the force on its load cell by far more than noise.
std::vector<char> FindStandstill(const std::vector<double>& samples, const std::vector<char>& bad,
                                 double step_s, double noise);

}  // namespace phs::identify
