// A gauge picks up what another channel shows: a common return wire, a damp plug, cables side by
// side, a multiplexer that keeps a share of the channel before.
//   shown = true + a u                                   T = 0
//   shown = true + a (u - z),  T dz/dt = u - z           through a capacitance: what is quick alone
// u: rise of the other gauge above static [Pa], or what the load cell carries, tension > 0 [N];
// z = u at first. a [-] or [Pa/N], T [s].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorCrosstalkInfo();

}  // namespace phs::effects
