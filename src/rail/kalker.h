// Kalker's creepage coefficients C11, C22, C23, C33 of an elliptic contact.
//
// Linear theory (Kalker 1967; values: Kalker, Three-Dimensional Elastic Bodies in Rolling Contact,
// 1990, table E.3), force on the rail with CONTACT's sign of creepage:
//   Fx = -G a b C11 xi
//   Fy = -G a b C22 eta - G (a b)^(3/2) C23 phi
//   Mz = +G (a b)^(3/2) C23 eta - G (a b)^2 C33 phi
// a along rolling, b across. Interpolation: linear in g = min(a/b, b/a) between the rows of the
// table, 1/C quadratic in the Poisson ratio (as CONTACT). Beyond a/b = 0.1 … 10 the end rows are
// scaled by the slender-ellipse asymptotes, so that the coefficients stay continuous. C33 is from
// one source only and spot-checked with CONTACT to 2-3 %.
#pragma once

#include "rail/creep.h"

namespace phs::rail {

struct KalkerCoefficients {
  double c11 = 0;
  double c22 = 0;
  double c23 = 0;
  double c33 = 0;
};

/// Coefficients at one aspect ratio a/b > 0 and Poisson ratio 0 … 0.5.
KalkerCoefficients CalcKalkerCoefficients(double a_over_b, double poisson_ratio);

/// The same for one material, tabulated finely over a/(a + b): a few nanoseconds per
/// look-up. Beyond a/b = 1/150 … 150 the end values are kept.
class KalkerCurve {
 public:
  explicit KalkerCurve(double poisson_ratio);
  KalkerCoefficients At(double a_over_b) const noexcept;
  /// By the ratio chi = a/(a + b) itself, 0 … 1.
  KalkerCoefficients AtShare(double chi) const noexcept;

 private:
  static constexpr int kIntervals = 2048;
  KalkerCoefficients knot_[kIntervals + 1];
};

/// The linear law above: no limit to the force.
CreepForce CalcLinearCreep(const CreepInput& input, const KalkerCoefficients& c,
                           double shear_modulus) noexcept;

}  // namespace phs::rail
