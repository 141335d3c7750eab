// Readings that share one bridge supply: it sags with what the rig draws, and all of them show less
// by one share y of themselves (ratiometric gauges: shown = true V/V_0).
//   y = of_speed |v|/(10 mm/s) + of_power max(F v, 0)/1 kW, with a lag T: T dy'/dt = y - y'
// |v|: current of a drive that works against its own drag; F v: the power that the rig takes in.
// Load cell, bore and rod gauge; or one of them alone. Pressures are absolute.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorSupplyInfo();

}  // namespace phs::effects
