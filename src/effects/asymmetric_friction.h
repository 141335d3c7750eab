// Friction differs by direction beyond the declared curve: level + d in extension, - d in
// retraction, kept >= 0, or one way alone |d| more (one_way: in extension where d > 0); viscous + e v
// in extension only counted against retraction (coefficients c0 + e, c0). d turns over a speed of
// its own (added_friction.h). d [N] -1000 … 1000; e [N s/m]. Dissipative as long as the level stays
// positive.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& AsymmetricFrictionInfo();

}  // namespace phs::effects
