// Oil that passes the piston seal from the chamber of higher pressure to the other.
//   q = G (p_bore - p_rod),   dV_bore/dt = -q,  dV_rod/dt = +q
// G conductance [m3/(Pa s)], laminar gap flow (Merritt, Hydraulic Control Systems, 1967, eq. 2-35:
// G = pi D c³/(12 mu l)). Where a lip lifts one way and is pressed on the other, G from rod to bore
// is return_ratio times as large. A sound polyurethane seal: below 1e-14; worn: 1e-13 … 1e-12. Lost
// power q (p_bore - p_rod). State: volume that has passed [m3].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& PistonLeakageInfo();

}  // namespace phs::effects
