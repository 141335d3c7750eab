// A piston seal that gives way in its groove: its ring stands towards the bore or the rod as the
// pressure difference d = p_bore - p_rod says, and on its way carries oil to the other side.
//   W_0(d) = V/2 tanh((d - d_c)/P)      where it would stand, as volume towards the rod [m3]
//   dW/dt = (W_0(d -+ P_h) - W)/tau     once d is P_h beyond; else it stays, held by its friction
// V [m3] clearance of the groove times area of the ring (8 mm wide, in a bore of 100 mm, with
// 0.1 mm: 2.5e-7), P [Pa] half the difference over which it crosses, d_c [Pa] where it stands in the
// middle, P_h [Pa] friction over area, tau [s] of its sliding (2 ms: as fast as the pressures).
// Elastic with friction: it stores d_c W + P V/2 (u artanh u + ln(1 - u²)/2), u = 2W/V.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SealShuttleInfo();

}  // namespace phs::effects
