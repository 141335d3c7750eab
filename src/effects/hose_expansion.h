// Hoses and structure that widen with pressure and stiffen: V(p) = C p_k ln((p_k + p)/(p_k + p0)).
// C [m3/Pa] compliance at low pressure: 1 m of 12 mm two-braid hose about 2e-13 … 1e-12; p_k [Pa]:
// pressure at which it has doubled its stiffness (1e9 = linear). Elastic.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& HoseExpansionInfo();

}  // namespace phs::effects
