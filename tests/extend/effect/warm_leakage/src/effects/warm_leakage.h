// A leak to the atmosphere that opens as the PHS warms up: a seal that shrinks in its groove.
//   q = G s (p - p_a),   s = (T - T_static - dT_open)/dT_range within 0 … 1,   dV_line/dt = -q
// G [m3/(Pa s)] fully open. Dissipative. State: volume lost [m3].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& WarmLeakageInfo();

}  // namespace phs::effects
