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

/// The table itself, and the row of laws that models bring with them (own_law.h): hydraulics knows
/// it only as hydraulics::EffectTable.
const hydraulics::EffectTable& Catalogue();

}  // namespace phs::effects
