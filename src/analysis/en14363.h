// Assessment of one wheelset's guiding and wheel forces on one track section (EN 14363, UIC 518).
//
//   sum_Y      low-pass 20 Hz, mean over 2 m every 0.5 m, larger size of the 0.15 and 99.85 %
//              percentiles; limit of Prud'homme
//   Y_over_Q   quotient of a wheel's two means over 2 m, the same percentiles; limit 0.8
//   Q          low-pass 20 Hz, 99.85 %; limit 90 kN + Q0, at most 200 kN
//   Y_qst      low-pass 20 Hz, median, outer wheel; limit 60 kN, and on radii below 400 m
//              30 kN + 10500 kN m/R
//   Q_qst      low-pass 20 Hz, median; limit 145 kN
//   unloading  1 - Q/Q0, low-pass 20 Hz, 99.85 %; limit 1: the wheel has lifted off (ours)
//   sum_Y_rms  band f0 +- 2 Hz, root mean square over 100 m every 10 m, largest; limit half of
//              Prud'homme's (instability; only when f0 is given)
// The limits hold for 1435 mm track and 22.5 t; on Cape gauge and 26 t they are orientation. Limits
// of Q, Y_qst, Q_qst and sum_Y_rms are from secondary sources. A single simulated section replaces
// neither the standard's set of sections nor its statistics over them.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::analysis {

/// Forces of one wheelset over a section, sampled at equal intervals.
struct WheelsetForces {
  std::vector<double> distance_m;  ///< place along the track, never falls
  std::vector<double> y_left_N;    ///< guiding force of the wheel on the rail, > 0 to the left
  std::vector<double> y_right_N;
  std::vector<double> q_left_N;  ///< vertical wheel force > 0
  std::vector<double> q_right_N;
};

struct SectionConditions {
  double interval_s = 0;           ///< sampling interval > 0, below 1/40 s
  double static_wheel_load_N = 0;  ///< Q0 > 0
  double radius_m = 0;             ///< size of the curve radius; 0 = straight
  double prudhomme_factor = 1;     ///< k1: 1 locomotives, coaches; 0.85 freight wagons
  double hunting_Hz = 0;           ///< f0 > 2 Hz; 0 = no assessment of instability
};

struct AssessedQuantity {
  std::string name;
  double value = 0;  ///< size of the larger percentile (see above)
  double limit = 0;
  bool kept() const { return value <= limit; }
};

/// Rows in the order above; Y_over_Q, Q, Y_qst, Q_qst and unloading are those of the worse wheel.
/// Fails when the sizes differ, the section is shorter than 2 m, or sampling is too slow.
Result<std::vector<AssessedQuantity>> AssessWheelset(const WheelsetForces& forces,
                                                     const SectionConditions& conditions);

/// Body acceleration: band 0.4 … 10 Hz.
struct AccelerationStatistics {
  double low = 0;   ///< 0.15 % [m/s^2]
  double high = 0;  ///< 99.85 %
  double rms = 0;
};
Result<AccelerationStatistics> AssessAcceleration(const std::vector<double>& acceleration_m_s2,
                                                  double interval_s);

}  // namespace phs::analysis
