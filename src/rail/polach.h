// Polach's closed form of the creep force (Polach, A fast wheel-rail forces calculation computer
// code, Vehicle System Dynamics Suppl. 33 (1999) 728; with kA, kS: Wear 258 (2005) 992).
//
//   s_yc = eta + phi a if that is the larger in size, else eta;  s = sqrt(xi^2 + s_yc^2)
//   c    = sqrt((C11 xi/s')^2 + (C22 eta/s')^2),  s' = sqrt(xi^2 + eta^2)
//   e    = G pi a b c s/(4 f N)
//   F    = -(2 f N/pi) (kA e/(1 + (kA e)^2) + atan(kS e))
//   q    = 1 + 6.3 (1 - exp(-a/b))
//   e_s  = (8/3) G b sqrt(a b) C23 |s_yc|/(f N q)
//   d    = (e_s^2 - 1)/(e_s^2 + 1)
//   K    = |e_s| (d^3/3 - d^2/2 + 1/6) - (1/3) sqrt((1 - d^2)^3)
//   x    = F xi/s
//   y    = F eta/s + (9/16) a f N K q phi/s      (K <= 0)
// Made for small spin; at flange spin it can exceed f N by far, so it is scaled back to f N (ours).
// It has no spin moment.
#pragma once

#include "rail/creep_law.h"
#include "rail/kalker.h"

namespace phs::rail {

/// @pre a, b, normal, friction > 0; 0 < slip_factor <= adhesion_factor <= 1.
CreepForce CalcPolach(const CreepInput& input, const KalkerCoefficients& c, double shear_modulus,
                      double adhesion_factor, double slip_factor) noexcept;

/// The law by that name.
CreepLawRow PolachRow();

}  // namespace phs::rail
