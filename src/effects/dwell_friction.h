// Breakaway grows with the time at rest: level + F_d phi, dphi/dt = (1 - phi)/tau - phi |v|/d.
// F_d [N] 0 … 2000 extra after long rest, tau [s] 0.1 … 1000, d [m] sliding that wipes it out 1e-5
// … 1e-3. State: 1 - phi; it begins rested. Dissipative.
// Logarithmic: level + F_d ln(1 + theta/tau), dtheta/dt = 1 - |v| theta/d, as contacts age (rate-and-
// state friction, the ageing law: Dieterich 1979, Ruina 1983). F_d [N] per e-fold of rest, tau [s]
// rest below which nothing has aged, 0.01 … 1. State: ln(1 + theta/tau); it begins fresh.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& DwellFrictionInfo();

}  // namespace phs::effects
