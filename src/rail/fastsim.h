// FASTSIM: the simplified theory of rolling contact (Kalker 1982) on an ellipse.
//
// Rigid slip (rail against wheel, per unit of rolling) at (x, y): s = (xi - phi y, eta + phi x).
// Flexibilities L1 = 8a/(3 C11 G), L2 = 8a/(3 C22 G), L3 = pi a sqrt(a/b)/(4 C23 G). Strips in y
// are marched from the leading edge x = +a: p -= dx (xi/L1 - phi y/L3, eta/L2 + phi x/L3), cut back
// to |p| <= mu p_z. Bound p_z: parabolic 2N/(pi a b)(1 - r^2) (classic; consistent with the theory)
// or Hertz's elliptic 3N/(2 pi a b) sqrt(1 - r^2). Tractions are taken at cell centres.
#pragma once

#include "rail/creep_law.h"
#include "rail/kalker.h"

namespace phs::rail {

struct FastsimGrid {
  int strips = 40;  ///< across
  int slices = 40;  ///< along
  bool elliptic_bound = false;
};

/// Force on the rail in CONTACT's sign (x, y) [N] and spin moment [N m].
CreepForce CalcFastsim(const CreepInput& input, const KalkerCoefficients& c, double shear_modulus,
                       const FastsimGrid& grid) noexcept;

}  // namespace phs::rail
