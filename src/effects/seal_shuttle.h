// A piston seal that gives way in its groove: its ring stands towards the bore or the rod as the
// pressure difference d = p_bore - p_rod says, and on its way carries oil to the other side.
//   W_0(d) = V/2 tanh((d - d_c)/P), held by the ring's friction P_h [Pa]         (snap_flow.h)
// V [m3] clearance of the groove times area of the ring (8 mm wide, in a bore of 100 mm, with
// 0.1 mm: 2.5e-7), volume towards the rod; P [Pa] half the difference over which it crosses,
// d_c [Pa] where it stands in the middle, tau [s] of its sliding (2 ms: as fast as the pressures).
// P far above the pressures: a wall between the two lines that bends, V/2P [m3/Pa].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SealShuttleInfo();

}  // namespace phs::effects
