// The block `effects:` alone, as it stands in a PHS model and in a scenario.
#pragma once

#include <string>
#include <vector>

#include "base/yaml.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// `map`: names to {targets, formula, numbers}. Names and keys are checked by who uses them.
std::vector<EffectParams> ReadEffects(YamlMap map);
/// "effects:" and what belongs under it; empty if there are none.
std::string EffectsToYaml(const std::vector<EffectParams>& effects);

}  // namespace phs::hydraulics
