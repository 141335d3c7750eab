// The diaphragm of the reservoir bottoms before its gas is compressed to nothing: gas volume stays
// at or above V_min [m3], then only the oil yields. Elastic. Table B-1, setup 3, points to it.
// At the other end it rests on the oil port: below the precharge p_c [Pa] gas volume stays at V_g0
// p0/p_c (by Boyle; p0, V_g0 as filled), and again only the oil yields.
// It lays itself on the wall part by part: three equal parts of the gas stop at volumes whose
// standard deviation over their mean is `spread`; 0 = all at once. What it meets may give way (a
// rubber bead): beyond the stop the gas changes by `1 - share` of each further volume only, as if
// this part of it met no stop.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& DiaphragmStopInfo();

}  // namespace phs::effects
