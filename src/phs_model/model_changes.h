// Changes of a PHS model that was read already.
#pragma once

#include <string>

#include "base/yaml.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {

/// The map `phs_parameters`, with the place of each number.
void ReadParameters(YamlMap map, PhsChanges* changes);
/// Effects first, then parameters (theirs, too), then the failures that concern `system`.
Status ApplyChanges(const PhsChanges& changes, const std::string& system,
                    hydraulics::PhsParams* params);

}  // namespace phs::phs_model
