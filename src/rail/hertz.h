// Hertz contact of two bodies of the same material, explicit in the approach.
//
// A, B = half the sum of curvatures along and across [1/m]; E* = G/(1 - nu). With the ratio of the
// axes g = minor/major and the complete elliptic integrals K, E of e^2 = 1 - g^2 (Johnson, Contact
// Mechanics, 1985, section 4.2):
//   (larger curvature)/(smaller) = (E/g^2 - K)/(K - E)
//   minor^2 = approach E / ((A + B) K),   major = minor / g
//   N = (2 pi/3) E* (A + B) minor^3 / (g E),   p0 = 3N/(2 pi a b)
// N grows with approach^(3/2); stored energy = 2/5 N approach.
#pragma once

#include <vector>

namespace phs::rail {

struct HertzContact {
  double a = 0;              ///< semi-axis along [m]
  double b = 0;              ///< semi-axis across [m]
  double normal = 0;         ///< [N]
  double peak_pressure = 0;  ///< [Pa]
  double approach = 0;       ///< [m]
};

/// Tabulated over the ratio of curvatures; a look-up costs a few nanoseconds.
class Hertz {
 public:
  Hertz(double shear_modulus_Pa, double poisson_ratio);
  /// Contact at approach > 0 [m]; curvature halves A (along) and B (across) > 0 [1/m].
  HertzContact AtApproach(double approach, double along, double across) const noexcept;
  /// Contact under a load >= 0 [N].
  HertzContact UnderLoad(double normal, double along, double across) const noexcept;
  /// Hertz's force over approach^1.5 [N/m^1.5].
  double Stiffness(double along, double across) const noexcept;
  /// Approach under a load [m].
  double ApproachUnder(double normal, double along, double across) const noexcept;

 private:
  struct Shape {
    double g = 1;         ///< minor / major
    double e_over_k = 1;  ///< E/K
    double e = 1;         ///< E
  };
  Shape ShapeAt(double log_ratio) const noexcept;
  double modulus_;  ///< E* [Pa]
  std::vector<Shape> table_;
};

}  // namespace phs::rail
