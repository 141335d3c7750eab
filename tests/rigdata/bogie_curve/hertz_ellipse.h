// Two elastic bodies of the same material pressed together (Hertz 1881; Johnson, Contact Mechanics,
// 1985, section 4.2). Gap z = A x^2 + B y^2, x along the rolling direction; g = minor/major axis,
// e^2 = 1 - g^2, K and E complete elliptic integrals of e, E* = G/(1 - nu):
//   max(A,B)/min(A,B) = (E/g^2 - K)/(K - E),   minor^2 = d E/((A + B) K),
//   N = (2 pi/3) E* (A + B) minor^3/(g E)
#pragma once

#include <array>

namespace bogie_curve {

struct Material {
  double shear_modulus = 82e9;  // G [Pa]
  double poisson = 0.28;        // nu
};

struct Ellipse {
  double a = 0, b = 0;  // semi-axes along x and y [m]
  double normal = 0;    // N [N]
  double pressure = 0;  // largest, 3 N/(2 pi a b) [Pa]
  double Ratio() const { return a / b; }
};

class HertzEllipse {
 public:
  explicit HertzEllipse(const Material& material);
  // A, B > 0 [1/m], depth d > 0 [m].
  Ellipse At(double A, double B, double depth) const;

 private:
  static constexpr int kRows = 400;
  struct Row {
    double g, K, E;
  };
  double modulus_;              // E*
  std::array<Row, kRows> row_;  // over the logarithm of the ratio of curvatures
};

}  // namespace bogie_curve
