// The diaphragm of the reservoir bottoms before its gas is compressed to nothing: gas volume stays
// at or above V_min [m3], then only the oil yields. Elastic. Table B-1, setup 3, points to it.
// It lays itself on the wall part by part: three equal parts of the gas stop at volumes whose
// standard deviation over their mean is `spread`; 0 = all at once. What it meets may give way (a
// rubber bead): below V_min the gas loses of each further volume `1 - share` only, as if this part
// of it met no stop.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& DiaphragmStopInfo();

}  // namespace phs::effects
