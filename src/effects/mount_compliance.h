// Elastic mounting in series with the cylinder: F = k (actuator - piston). k [N/m] 5e6 … 1e9; the
// thesis's rig shows 41 kN/mm. Stored energy F²/(2 k). State: deflection [m].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& MountComplianceInfo();

}  // namespace phs::effects
