// Mass that moves with a part on a bench: F = m a. Element rig only; on a vehicle masses belong to
// its bodies.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& MovingMassInfo();

}  // namespace phs::effects
