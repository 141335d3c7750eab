// Elastic motion before sliding: turns a static friction curve into the elasto-plastic bristle of
// hydraulics/bristle.h with stiffness sigma0 [N/m] 1e6 … 1e9 and breakaway ratio [-], or (creeping)
// into that of Dahl (1968) and of Canudas de Wit, Olsson, Astrom and Lischinsky (LuGre, IEEE Trans.
// Automatic Control 40 (1995) 419), with Dahl's exponent i [-]:
//   dz/dt = v g^i,   g = 1 - sgn(v) z/z_s.   i = 1: z_s - |z| falls as exp(-x/z_s) in sliding;
//   else g^(1-i) = g(0)^(1-i) + (i - 1) x/z_s: exact over any step. It creeps when shaken.
// With share < 1 only that share of the level sticks, the rest follows the static law.
// Stored energy sigma0 z²/2. State: bristle deflection [m].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& PreslidingInfo();

}  // namespace phs::effects
