// What is left of the motion at the end of a run: does hunting live after a disturbance?
//
// Over the last `window_s` of the run, about its mean: root mean square of the sum of Y of each
// wheelset and half the swing of its lateral position. A run that is shorter than twice the window,
// or that ended early, has nothing left to say: null.
#pragma once

#include <nlohmann/json.hpp>

#include "vehicle/simulation.h"

namespace phs::analysis {

inline constexpr double kLastSeconds = 10;  ///< [s]

/// `{"wheelsets": [{"name", "rms_sum_Y_N", "swing_m"}, …], "largest_rms_sum_Y_N", "largest_swing_m",
/// "rms_grows": of the wheelset with the largest, last half of the window over the half before}`.
nlohmann::ordered_json LastSeconds(const vehicle::Simulation& simulation,
                                   const vehicle::RunOutcome& run, double window_s = kLastSeconds);

}  // namespace phs::analysis
