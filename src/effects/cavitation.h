// Dissolved air comes out of the oil below a release pressure p_c and takes volume.
// By Henry's and Boyle's laws:
//   V(p) = b V_oil p_a (1/p - 1/p_c) for p < p_c, else 0
// b: solubility, volume of air at atmospheric pressure per oil volume dissolved per full release
// (Bunsen coefficient of mineral oil 0.09, of silicone oils to 0.2; a cavity that opens at p_c, as
// of vapour, looks like a still larger one, so up to 0.5 is taken for plausible). p_c [Pa] 2e3 …
// 1e6. At equilibrium elastic: a pulled line stays near p_c instead of going to zero. With a
// time given air comes out or goes back with a lag (dissolving_air.h), which stores and loses;
// state: the free share.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& CavitationInfo();

}  // namespace phs::effects
