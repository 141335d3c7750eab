// What is left of the motion at the end of a run: does hunting live after a disturbance?
//
// Over the last `window_s` of the run, about its mean: root mean square of the sum of Y of each
// wheelset and half the swing of its lateral position. A run that is shorter than twice the window,
// or that ended early, has nothing left to say.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "vehicle/simulation.h"

namespace phs::analysis {

inline constexpr double kLastSeconds = 10;  ///< [s]

/// What is not said is not a number.
struct LastSeconds {
  struct Wheelset {
    std::string name;
    double rms_sum_Y_N = 0;
    double swing_m = 0;
  };
  double window_s = 0;
  std::vector<Wheelset> wheelsets = {};
  double largest_rms_sum_Y_N = std::nan("");
  double largest_swing_m = std::nan("");
  /// Of the wheelset with the largest: last half of the window over the half before.
  double rms_grows = std::nan("");
};

LastSeconds CalcLastSeconds(const vehicle::Simulation& simulation, const vehicle::RunOutcome& run,
                            double window_s = kLastSeconds);

/// The same names; null for what is not said.
nlohmann::ordered_json LastSecondsJson(const LastSeconds& last);

}  // namespace phs::analysis
