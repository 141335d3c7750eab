// Air bubbles in the oil of a line: soft at low pressure, gone at high.
//   V_air(p) = a V_oil (p_a/p)^(1/n) s(p)²
//   s = 1, or with dissolving 1 - (p - p_a)/(p_s - p_a) >= 0
// a: air volume at atmospheric pressure per oil volume, 0.001 … 0.05; n: 1 (slow) … 1.4 (fast); p_s
// [Pa]: pressure at which all air is dissolved (Henry), 0 = it stays. Volume taken up: V(p0) -
// V(p). Elastic: stored energy is the integral of p dV. Source of the two-phase balance: Merritt
// (1967) 2-2.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& EntrainedAirInfo();

}  // namespace phs::effects
