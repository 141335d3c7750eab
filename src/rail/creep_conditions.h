// Rail conditions by name: friction of tread and flange, and the slope of the creep curve.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "rail/creep_law.h"

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

/// Puts the condition's slope into the parameters of a law.
void ApplyCondition(const FrictionCondition& condition, CreepLawParams* params);

}  // namespace phs::rail
