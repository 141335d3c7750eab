// Carter's two-dimensional rolling contact: the exact theory of a line contact, to hold the others
// against.
//
// Two cylinders, 1/R = 1/R1 + 1/R2, half width a, friction f. The adhesion zone lies at the leading
// edge with half width a' (Carter, On the action of a locomotive driving wheel, Proc. R. Soc. A 112
// (1926) 151; Johnson, Contact Mechanics, 1985, section 8.3):
//   a'/a = 1 - |xi| R/(f a),   F = -sign(xi) f N (1 - (a'/a)^2),   full sliding below a' = 0.
#pragma once

namespace phs::rail {

/// Force on the rail over f N, in [-1, 1]. @pre relative_radius R, half_width a, friction > 0.
double CalcCarter(double xi, double relative_radius, double half_width, double friction);

/// The same for an ellipse far longer across than along (b >> a), strip by strip: half width
/// a sqrt(1 - y^2), load by 1 - y^2.
double CalcCarterStrips(double xi, double relative_radius, double half_width, double friction);

}  // namespace phs::rail
