// Inertia of the oil in the pipe between each chamber and its line.
//   I dq/dt = p_chamber - p_line - R q
// I = rho l/A [kg/m4]: 2 m of 12 mm pipe 1.6e7. R damps [Pa s/m3]. The chamber keeps `oil_share` of
// the line's oil on its side, so that line and chamber have pressures of their own. A rod_ratio
// below 1/20 or above 20 leaves the smaller side without. Kinetic energy I q²/2. States: volume
// passed [m3], flow [m3/s].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& LineInertanceInfo();

}  // namespace phs::effects
