// Hunting as a limit cycle: how large it is over speed and below which speed it cannot live.
//
// Time runs on straight track. The forward speed of the vehicle's root is prescribed, as by a heavy
// train: after every step all bodies, spins included, get the same change of forward speed. The
// down ramp starts above the linear critical speed in the shape of the least stable mode and slows
// down until the motion dies; the up ramp starts below with a small disturbance, renewed whenever
// it has died away. A ramp lags behind, so the speed at which the cycle dies is then found by
// bisection with runs at constant speed that start from the cycle of a higher speed.
#pragma once

#include <vector>

#include "analysis/stability.h"

namespace phs::analysis {

struct LimitCycleOptions {
  double high_speed_m_s = 0;    ///< where the down ramp starts
  double low_speed_m_s = 0;     ///< where it ends at the latest, > 0
  double rate_m_s2 = 0.5;       ///< of both ramps, > 0
  double disturbance_m = 4e-3;  ///< of the down ramp, lateral at a wheelset
  double small_m = 1e-4;        ///< of the up ramp
  double alive_m = 5e-4;        ///< amplitude below which the motion has died
  double settling_s = 12;       ///< of each run at constant speed
  double resolution_m_s = 0.1;  ///< of the bisection
};

struct RampPoint {
  double speed = 0;      ///< [m/s]
  double amplitude = 0;  ///< half the swing of the leading wheelset's lateral motion over 1 s [m]
};

struct LimitCycle {
  std::vector<RampPoint> down;
  std::vector<RampPoint> up;
  double critical_speed = 0;  ///< the cycle dies below it; NaN if it did not live or did not die
  double amplitude = 0;       ///< of the cycle at the lowest speed at which it lived [m]
  bool derailed = false;      ///< the down ramp left the rails: start at a lower speed
};

/// `mode`: the shape of the disturbance (of AnalyseStability).
Result<LimitCycle> FindLimitCycle(vehicle::Simulation* simulation, const VibrationMode& mode,
                                  const LimitCycleOptions& options,
                                  const vehicle::Progress& progress = {});

}  // namespace phs::analysis
