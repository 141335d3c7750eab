// A rubber bush in series with the cylinder: spring and Maxwell element in parallel (Zener).
//   F = k u + k2 (u - q),  dq/dt = (u - q)/tau
// k [N/m] slow stiffness, k2 [N/m] extra fast stiffness, tau [s] relaxation 1e-3 … 100.
// Stored k u²/2 + k2 (u - q)²/2, lost k2 (u - q)²/tau. States: u, q [m].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& BushViscoelasticInfo();

}  // namespace phs::effects
