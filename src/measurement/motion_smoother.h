// Position and speed of a driven part from noisy samples, without lag.
//
// Kalman filters and Rauch-Tung-Striebel smoothers (AIAA Journal 3 (1965) 1445) of motions whose
// third, fifth or seventh derivative is white: what may turn within a sample, and what goes
// smoothly and therefore foretells itself, so that little of the noise is left and none of it far
// above the frequencies that move. How lively the motion is, the strength q(t) of the white
// derivative, comes from the data: of each kind a bank of filters is run, and at every instant the
// strength is taken that predicts the samples around it best (likelihood over 41 samples); the
// kinds are blended by the same likelihood. Where the part rests, q is tiny and the speed settles
// at zero within its small uncertainty, so that the sign of friction does not flicker; at reversals
// and steps it is large and nothing is rounded off: there the noise comes through. Position and
// speed belong to one motion: differences of positions follow the speeds.
#pragma once

#include <vector>

namespace phs::measurement {

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

}  // namespace phs::measurement
