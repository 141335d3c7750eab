// What the catalogue does not hold, as found in data: a force given by a formula with units
// (force_formula.h), e.g. formula: "c1*s*(p/5e5[Pa])", c1_N: 3.4. It acts on the piston beside
// friction. Not passive by construction: it is what was measured.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& UnlistedInfo();

}  // namespace phs::effects
