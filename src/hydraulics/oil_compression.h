// How oil gives way: its bulk modulus beta(p) and the volume that it takes up per volume of oil.
//
//   constant            beta0                          V = u/beta0,  u = p - p0
//   rises evenly        beta0 + m u                    V = ln(beta/beta0)/m
//   rises over P        beta0 + R (1 - exp(-u/P))      V = (u + P ln(beta/beta0))/(beta0 + R)
//
// The last one is oil with its hoses and joints as measured: much softer at low pressure, hardly
// stiffening beyond 8.5 MPa (H. Yang, B. Feng, G. Gong, J. Dyn. Sys. Meas. Control 133 (2011)
// 061021). Elastic: stored is int p dV.
#pragma once

namespace phs::hydraulics {

struct OilStiffness {
  double modulus = 0;  ///< beta0, at the static pressure [Pa]
  double slope = 0;    ///< m [-], >= 0
  double rise_Pa = 0;  ///< R [Pa], >= 0; > 0: in the place of the slope
  double over_Pa = 0;  ///< P [Pa]

  bool IsConstant() const { return slope == 0 && rise_Pa == 0; }
  double At(double rise) const;
  /// Volume taken up since p0, per volume of oil; `compliance` = d/dp [1/Pa].
  double Volume(double rise, double* compliance) const;
  /// int p dV from p0, per volume of oil [Pa].
  double Energy(double p0, double rise) const;
};

}  // namespace phs::hydraulics
