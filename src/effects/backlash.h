// Free play between mounting and piston: within the total gap g no force, beyond it a stiff
// contact.
//   F = k e,  e = u - sgn(u) min(|u|, g/2),  u = actuator - piston
// g [m] 1e-5 … 2e-3; k [N/m] contact stiffness, counted in series with a mounting compliance if
// there is one. Stored energy k e²/2. State: u.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& BacklashInfo();

}  // namespace phs::effects
