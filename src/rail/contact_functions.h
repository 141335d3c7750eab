// Contact functions of a wheelset on a pair of rails: rolling radii, contact angles, roll and
// height over the lateral position, without yaw; and the equivalent conicity.
//
// Rigid bodies, or elastic ones under a load on each wheel: then radius, angle and place are means
// over all patches, weighted with their normal forces (quasi-elastic contact).
// Where a rigid wheel jumps from tread to flange root, an elastic one bears on both.
//
// At a lateral position y (to the right) the wheelset has the roll at which both wheels touch; where
// there are several (a flange may also climb), the one that goes on from the middle. With
// the rolling-radius difference Dr(y) = r_right - r_left, the distance e of the contact points at
// rest and the radius r0 there, the free wheelset runs (EN 15302:2008, annex B)
//   y'' = -(Dr(y) - Dr(y0))/(e r0) about the place y0 where it rolls straight, Dr(y0) = 0,
// a wave of length L for each amplitude; the conicity of the cone with the same wave is
//   tan(gamma_e) = (pi/L)^2 2 e r0.
#pragma once

#include <vector>

#include "base/result.h"
#include "rail/wheel_rail.h"

namespace phs::rail {

struct ContactFunctionRow {
  double y = 0;       ///< lateral position, to the right [m]
  double roll = 0;    ///< right-handed about x forward [rad]
  double height = 0;  ///< of the centre below that of y = 0 (z down) [m]
  TouchPoint left, right;
  double RadiusDifference() const { return right.radius - left.radius; }
};

struct Conicity {
  double amplitude = 0;  ///< half the way between the turning points [m]
  double value = 0;      ///< tan(gamma_e)
};

struct ContactFunctions {
  std::vector<ContactFunctionRow> rows;
  std::vector<Conicity> conicity;
  double centre = 0;     ///< y0 [m]
  double half_base = 0;  ///< e/2 [m]
};

/// From -reach to reach by `step` [m]; rows where a wheel finds no rail are left out. `load` on
/// each wheel [N], 0 = rigid bodies. The conicity for amplitudes of 1 mm, 1.5 mm … as far as both
/// turning points lie within the rows. An error if the wheelset does not touch near the centre, or
/// nowhere rolls straight.
Result<ContactFunctions> CalcContactFunctions(const WheelRail& left, const WheelRail& right,
                                              double reach, double step, double load = 0);

}  // namespace phs::rail
