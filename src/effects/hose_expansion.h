// Hoses and structure that widen with pressure and stiffen:
//   dV/dp = C ((p_k + p)/(p_k + p_s))^-m,   m = 1: V = C (p_k + p_s) ln((p_k + p)/(p_k + p0))
// C [m3/Pa] compliance at the pressure p_s (`stated_at_Pa`, 0: at none): 1 m of 12 mm two-braid
// hose about 2e-13 … 1e-12; p_k [Pa]: pressure at which it has doubled its stiffness over that at
// none (1e9 = linear). Elastic. Data tell C where they were taken: a search states it at 2 MPa.
//
// A part may creep: tau dw/dt = C_c (p - p0) - w. Rubber creeps over decades of time: with
// `creep_spread` d > 1 a third of C_c each has the times tau/d, tau, tau d. A braid stops
// rubber that creeps, too: with `late_share` s that share of V comes late, tau dw/dt = s V(p) - w.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& HoseExpansionInfo();

}  // namespace phs::effects
