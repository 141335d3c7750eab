// Force proportional to speed, c v, with a coefficient per direction [N s/m], 0 … 1e5. Dissipative.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& ViscousFrictionInfo();

}  // namespace phs::effects
