// Breakaway grows with the time at rest: level + F_d phi, dphi/dt = (1 - phi)/tau - phi |v|/d.
// F_d [N] 0 … 2000 extra after long rest, tau [s] 0.1 … 1000, d [m] sliding that wipes it out 1e-5
// … 1e-3 (rate-and-state friction: Dieterich 1979, Ruina 1983). State: 1 - phi. Dissipative.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& DwellFrictionInfo();

}  // namespace phs::effects
