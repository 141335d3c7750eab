// Free play between mounting and piston: no force within the total gap g, a stiff contact beyond.
//   F = k e (1 + b e²),   u = actuator - piston
//   e = u - s g above s g, u + (1 - s) g below -(1 - s) g, 0 between
//
// g [m] 1e-5 … 2e-3; s: share of the play on the way to tension, 1/2 where the pin rests in its
// middle; k [N/m] contact stiffness, counted in series with a mounting compliance if there is one;
// b [1/m2] contact that stiffens as it is pressed. Stored energy k e²/2 (1 + b e²/2). State: u.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& BacklashInfo();

}  // namespace phs::effects
