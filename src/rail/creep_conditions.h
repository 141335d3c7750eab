// Rail conditions by name: friction of tread and flange, and the slope of the creep curve.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "rail/creep_law.h"
#include "rail/wheel_rail.h"

namespace phs::rail {

struct FrictionCondition {
  std::string name;
  FrictionLaw tread;
  FrictionLaw flange;
  double polach_adhesion = 1;      ///< kA
  double polach_slip = 1;          ///< kS
  SlopeReduction slope_reduction;  ///< of fastsim and kalker_table
  std::string source;
};

/// dry: constant 0.3, theory's slope. dry_traction, wet_traction: Polach's measured parameters with
/// falling friction. eurosprinter: fit of a wet-rail traction test. flange_lubricated: dry tread,
/// 0.1 on the flange. wet: constant 0.15.
const std::vector<FrictionCondition>& FrictionConditions();
Result<FrictionCondition> FindFrictionCondition(const std::string& name);
std::vector<std::string> FrictionConditionNames();

/// Friction as a user asks for it; empty or < 0 = not asked for.
struct FrictionSettings {
  std::string condition;         ///< name
  double tread = -1;             ///< coefficient f0, instead of the condition's
  double flange = -1;            ///< as `tread` if no condition is given either
  double falling_ratio = -1;     ///< A of both, (0, 1]
  double falling_rate_s_m = -1;  ///< B of both [s/m]
};

/// Puts the settings over the friction and the creep law of `params`. An unknown condition is an
/// error that lists the known ones.
Status ApplyFriction(const FrictionSettings& settings, WheelRailParams* params);

}  // namespace phs::rail
