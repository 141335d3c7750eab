// What wheel, track and suspension may be beside what is declared: the same idea as the catalogue
// of the PHS (src/effects), one name each, in scenarios, results and code. A scenario has them by:
//
//   effects:
//     tread_wear: {depth_m: 0.0006}              # hollow: src/rail/tread_wear.h
//     wheel_rail_friction: {coefficient: 0.22}   # of the tread; of the flange if it had the same
//     cant_error: {cant_m: -0.015}               # of every curve, > 0 raises the outer rail
//     gauge_error: {widening_m: 0.006}           # everywhere
//     box_spring: {targets: [lead_left], factor: 0.6}   # springs of one axle box: box_springs.h
//     viscous_friction: {…}                      # effects of the PHS go to its model
#pragma once

#include <string>
#include <vector>

#include "hydraulics/extension.h"
#include "phs_model/phs_model.h"
#include "vehicle/scenario.h"

namespace phs::vehicle {

/// What a scenario declares of the numbers that effects of wheel and track are about.
struct DeclaredRunning {
  double friction = 0;             ///< of wheel on rail
  std::vector<std::string> boxes;  ///< axle boxes on springs (box_springs.h)
};

struct RunningEffect {
  hydraulics::EffectInfo info;  ///< `install` is null: nothing of it enters a PHS
  /// Changes the scenario; every value is there and inside its range. The targets are names that
  /// the vehicle is yet to be asked for; none: all.
  void (*apply)(const hydraulics::EffectParams& effect, Scenario* scenario);
  /// As EffectSearch::declared, of what a scenario says.
  double (*declared)(const DeclaredRunning& declared) = nullptr;
};

/// The table.
const std::vector<RunningEffect>& RunningEffects();
/// A row by name, or null.
const RunningEffect* FindRunningEffect(const std::string& name);

/// Switches one effect of either catalogue on. Errors name the effect or key and what is allowed.
Status AddEffect(const hydraulics::EffectParams& effect, Scenario* scenario);

}  // namespace phs::vehicle
