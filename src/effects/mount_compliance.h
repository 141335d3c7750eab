// Elastic mounting in series with the cylinder: F = k (actuator - piston). k [N/m] 5e6 … 1e9; the
// thesis's rig shows 41 kN/mm. Stored energy F²/(2 k). State: deflection [m].
// A bolted joint gapes once tension has used up its preload F_o (opens_N): beyond, the bolts alone
// give way, r k (VDI 2230: clamped parts and bolts share a force until they part).
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& MountComplianceInfo();

}  // namespace phs::effects
