// Elastic motion before sliding: turns a static friction curve into the elasto-plastic bristle of
// hydraulics/friction.h with stiffness sigma0 [N/m] 1e6 … 1e9 and breakaway ratio [-], or
// (creeping) into that of Dahl with his exponent i [-].
// Stored energy sigma0 z²/2. State: bristle deflection [m].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& PreslidingInfo();

}  // namespace phs::effects
