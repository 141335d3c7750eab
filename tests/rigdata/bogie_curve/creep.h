// Creep forces: Kalker's linear theory (1967), and his simplified theory where friction limits them
// (FASTSIM: J. J. Kalker, Vehicle System Dynamics 11 (1982) 1).
//
// Axes: 1 along the rail, 2 across in the contact plane, n into the rail, right-handed. v1, v2, wn:
// velocity and spin of the wheel against the rail over the speed. Forces on the wheel, linear:
//   F1 = -G a b C11 v1
//   F2 = -G a b C22 v2 - G (a b)^(3/2) C23 wn
//   Mn = +G (a b)^(3/2) C23 v2 - G (a b)^2 C33 wn
// Simplified: in strips along 1, from the leading edge backwards,
//   dt = -dx (v1/L1 - wn y/L3, v2/L2 + wn x/L3),   |t| <= mu 2N/(pi a b) (1 - (x/a)^2 - (y/b)^2)
//   L1 = 8a/(3 C11 G), L2 = 8a/(3 C22 G), L3 = pi a sqrt(a/b)/(4 C23 G)
// C: Kalker 1967, the columns of nu = 1/4 and 1/2, linear between; a/b within 0.1 … 10.
#pragma once

#include "hertz_ellipse.h"

namespace bogie_curve {

struct KalkerNumbers {
  double c11, c22, c23, c33;
};
KalkerNumbers CalcKalkerNumbers(double a_over_b, double poisson);

struct Creepage {
  double v1 = 0, v2 = 0, wn = 0;
};
struct CreepWrench {
  double f1 = 0, f2 = 0, mn = 0;
};
CreepWrench CalcLinearCreep(const Ellipse& ellipse, const Material& material,
                            const Creepage& creep);
CreepWrench CalcCreep(const Ellipse& ellipse, const Material& material, double friction,
                      const Creepage& creep);

}  // namespace bogie_curve
