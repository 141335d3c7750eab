// Oil that stiffens as it is pressed: its bulk modulus beta [Pa] rises with the pressure,
//   d(beta)/dp = K' [-],   V(p) = V_oil/K' ln(1 + K' (p - p0)/beta)
// (Murnaghan 1944, Proc. Natl. Acad. Sci. 30, 244). Of liquids K' is near 10 (Hayward 1967, Brit. J.
// Appl. Phys. 18, 965: the secant modulus rises by 5); gaskets and joints that seat stiffen a line
// beyond its oil. Elastic. At the static pressure beta stays as declared.
//
// Oil that joints, hoses and fine bubbles make soft stiffens at once and then no more:
//   beta(p) = B (1 - c exp(-p/P)),   B = beta(p0)/(1 - c exp(-p0/P))
// with `softness` c, the share that is missing at no pressure, and `over_Pa` P. Measured: H. Yang,
// B. Feng, G. Gong, J. Dyn. Sys. Meas. Control 133 (2011) 061021 (little beyond 8.5 MPa). Closed
// form of V: hydraulics/oil_compression.h.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& OilStiffeningInfo();

}  // namespace phs::effects
