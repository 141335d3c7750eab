// The two critical speeds of a bogie on straight track: of infinitely small motions, and the lowest
// at which hunting, once there, lives on.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/limit_cycle.h"
#include "analysis/stability.h"
#include "vehicle/scenario.h"

namespace phs::analysis {

struct CriticalSpeeds {
  double linear = 0;     ///< NaN: stable over the whole scan [m/s]
  double nonlinear = 0;  ///< NaN: see `hunting` [m/s]
  /// "dies" below `nonlinear`; "lives" down to the end of the ramp; "none" at its begin;
  /// "derailed" there.
  std::string hunting;
  double amplitude = 0;   ///< of the cycle there, lateral at the leading wheelset [m]
  double ramp_begin = 0;  ///< range of the ramp [m/s]
  double ramp_end = 0;
};

/// Ramps around the linear critical speed (or below the end of the scan): from 1.2 times it down to
/// a sixth. Speeds already set are kept.
LimitCycleOptions ChooseRamp(const StabilityOptions& scan, const StabilityResult& result,
                             LimitCycleOptions options);

/// The vehicle of `scenario` for runs in time on straight track: 1 ms, or less if its stiffness
/// asks for less.
Result<vehicle::Simulation> CreateForRamps(vehicle::Scenario scenario, double largest_step);

/// `scenario` gives bogie, vehicle, profiles, friction, creep law and PHS; track, speed, step,
/// traction and failures that happen on the way are replaced by free running on straight track.
Result<CriticalSpeeds> FindCriticalSpeeds(const vehicle::Scenario& scenario,
                                          const vehicle::Progress& progress = {});

/// `linear_m_s`, `nonlinear_m_s` (null where there is none), `hunting`, `amplitude_m`,
/// `ramp_from_m_s`, `ramp_to_m_s`.
nlohmann::ordered_json CriticalSpeedsJson(const CriticalSpeeds& speeds);

}  // namespace phs::analysis
