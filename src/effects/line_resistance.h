// Flow resistance between each chamber of a cylinder and its line.
//   p_chamber - p_line = R q + K q |q|
// R [Pa s/m3]: 2 m of 12 mm pipe with VG 68 at 20 °C 4e8 (hydraulics/pipe.h), valves and ports up
// to 1e11. K [Pa s2/m6]: bends and ports 1e11 … 1e15. The chamber keeps `oil_share` of the line's
// oil on its side, so that line and chamber have pressures of their own. Lost power (R + K|q|) q².
// State: volume that has passed [m3].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& LineResistanceInfo();

}  // namespace phs::effects
