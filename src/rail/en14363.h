// Assessment quantities of EN 14363 / UIC 518 from the time series of one section of track.
//
// | quantity            | filter             | method                          | statistic |
// |---------------------|--------------------|---------------------------------|--------------------|
// | sum Y (2 m)         | low-pass 20 Hz     | sliding mean 2 m, step 0.5 m    | 0.15 and 99.85 % |
// | Y/Q (2 m)           | low-pass 20 Hz     | of the two 2 m means            | 0.15 and 99.85 % |
// | Q                   | low-pass 20 Hz     | -                               | 99.85 % | | Yqst,
// Qqst          | low-pass 20 Hz     | -                               | 50 %               | |
// wheel unloading     | low-pass 20 Hz     | 1 - Q/Q0                        | 99.85 %            |
// | accelerations       | 0.4 … 10 Hz        | -                               | 0.15, 99.85 %, rms
// | | sum Y (instability) | f0 - 2 … f0 + 2 Hz | sliding rms 100 m, step 10 m    | largest |
// Source: EN 14363:2005, UIC 518 as tabulated by gensys.se/course/UIC518_tests.html. Forces in N on
// the rail, Y > 0 outward of its own rail is not assumed: signs only have to be the same for both
// wheels. Sections (tangent, transition, curve classes) are chosen by the caller.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace phs::rail {

/// Channels of one wheelset over one section, sampled uniformly.
struct WheelsetRecord {
  double sample_rate = 0;               ///< [Hz]
  std::vector<double> distance;         ///< [m], never falls
  std::vector<double> y_left, y_right;  ///< lateral force of wheel on rail, one sign for both [N]
  std::vector<double> q_left, q_right;  ///< vertical force >= 0 [N]
  double static_wheel_load = 0;         ///< Q0 [N]
  double instability_frequency = 0;     ///< f0 [Hz]; 0 = leave the instability criterion out
};

struct WheelStatistics {
  double y_over_q_2m = 0;  ///< largest size of the 0.15 and 99.85 % percentiles
  double q_max = 0;        ///< 99.85 % [N]
  double y_qst = 0;        ///< 50 % [N]
  double q_qst = 0;        ///< 50 % [N]
  double unloading = 0;    ///< 99.85 % of 1 - Q/Q0
};

struct WheelsetStatistics {
  double sum_y_2m = 0;       ///< largest size of the percentiles [N]
  double sum_y_rms_max = 0;  ///< instability: largest rms over 100 m [N]
  WheelStatistics left, right;
  double length = 0;  ///< of the section [m]
};

Result<WheelsetStatistics> CalcWheelsetStatistics(const WheelsetRecord& record);

struct AccelerationStatistics {
  double peak = 0;  ///< largest size of the 0.15 and 99.85 % percentiles [m/s^2]
  double rms = 0;   ///< [m/s^2]
};
Result<AccelerationStatistics> CalcAccelerationStatistics(const std::vector<double>& acceleration,
                                                          double sample_rate);

/// Limits. Made for 1435 mm gauge and 22.5 t axles: on other gauges and loads only orientation.
struct RunningLimits {
  double sum_y_2m = 0;  ///< Prud'homme k1 (10 kN + 2 Q0/3) [N]
  double y_over_q_2m = 0.8;
  double y_qst = 60e3;   ///< [N]; 30 kN + 10500 kN m/R in curves below 400 m (UIC 518)
  double q_qst = 145e3;  ///< [N]
  double q_max = 0;      ///< 90 kN + Q0, at most 200 kN (up to 160 km/h) [N]
  double sum_y_rms = 0;  ///< half of sum_y_2m [N]
};
/// `curve_radius` [m], 0 = straight; k1 = 1 (locomotives, coaches) or 0.85 (wagons).
RunningLimits CalcRunningLimits(double static_wheel_load, double curve_radius, double k1);

/// Curve class of EN 14363: "straight", "large", "small" (400 … 600 m), "very small" (250 … 400 m)
/// or "below 250 m".
std::string CurveClassOf(double curve_radius);

}  // namespace phs::rail
