// Air bubbles in the oil of a line: soft at low pressure, gone at high.
//   V_air(p) = a V_oil (p_a/p)^(1/n) s(p)
//   s = 1, or with dissolving 1 - (p - p_a)/(p_s - p_a) >= 0
// a: air volume at atmospheric pressure per oil volume, 0.001 … 0.05; n: 1 (slow) … 1.4 (fast;
// nitrogen 1.6 at 10 MPa, 1.77 at 15 MPa: isentropic, by bwr_nitrogen.h); p_s [Pa]: pressure at
// which all air is dissolved (Henry), 0 = it stays. With a lag of dissolving and, release_ratio
// times as long, of coming out again: dissolving_air.h. Volume taken up: V(p0) - V(p). Elastic:
// stored energy is the integral of p dV. Source of the two-phase balance: Merritt (1967) 2-2.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& EntrainedAirInfo();

}  // namespace phs::effects
