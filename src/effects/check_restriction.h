// A restriction that resists differently by flow direction: check valve with a bypass orifice.
//   p_chamber - p_line = R_out q  (q > 0: out of the chamber),   R_in q  (q < 0: into it)
// R [Pa s/m3] 1e8 … 1e13. The chamber keeps `oil_share` of
// the line's oil on its side, so that line and chamber have pressures of their own.
// Lost power R q². State: volume that has passed [m3].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& CheckRestrictionInfo();

}  // namespace phs::effects
