// The catalogue of effects a real PHS may have beside the declared model. One row per effect; the
// same name in model files, results and code.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/extension.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/phs_system.h"

namespace phs::effects {

/// The table itself: hydraulics knows it only as hydraulics::EffectTable.
const hydraulics::EffectTable& Catalogue();

/// Reads, checks and compiles a model file with its effects: the entry for rig, plugin and
/// programs.
Result<hydraulics::PhsSystem> LoadPhsSystem(const std::string& path);
/// The same from a name looked up in the data folders (models/phs) or a path.
Result<hydraulics::PhsParams> FindPhsParams(const std::string& name_or_path);
/// Compiles parameters with the catalogue.
Result<hydraulics::PhsSystem> CreatePhsSystem(const hydraulics::PhsParams& params);

/// Switches an effect on with its default parameters (all targets). Error: unknown name (nearest).
Status AddEffect(hydraulics::PhsParams* params, const std::string& effect);
/// Core parameters and those of the effects switched on, with unit and plausible range.
std::vector<hydraulics::ParameterInfo> ListAllParameters(const hydraulics::PhsParams& params);

}  // namespace phs::effects
