// The block `effects:` alone, as it stands in a PHS model and in a scenario.
#pragma once

#include <string>
#include <vector>

#include "base/yaml.h"
#include "hydraulics/phs_params.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {

/// `map`: names to {targets, formula, numbers}. Names and keys are checked by who uses them.
std::vector<hydraulics::EffectParams> ReadEffects(YamlMap map);
/// "effects:" and what belongs under it; empty if there are none.
std::string EffectsToYaml(const std::vector<hydraulics::EffectParams>& effects);

}  // namespace phs::phs_model
