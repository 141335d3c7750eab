// Friction that grows as the seals swell in the oil: they take it up by diffusion.
//   level (1 + g (1 - exp(-t/T)))     g growth [-], T time of swelling [s]
// Dissipative. No state.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SealSwellingInfo();

}  // namespace phs::effects
