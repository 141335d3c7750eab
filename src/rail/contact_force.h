// Normal and creep force of one patch from its overlap, and the elastic rail under it.
//
// With the unit vectors forward e1, lateral e2 (outwards in the contact plane) and normal n (into
// the rail), the velocity v = v_centre + omega x r of the wheel's material at the patch and
// Hertz's force N_H(depth), stiffness k' = 1.5 N_H/depth:
//   N = max(0, N_H + c v.n),   c = 2 D sqrt(k' m)
//   xi = -v.e1/V,  eta = -v.e2/V,  phi = -omega.n/V        (CONTACT's sign; the rail rests)
//   V = |v_x - v.e1/2|: mean of the speeds at which the contact travels over rail and wheel
//   (Kalker),
//       floored by a parabola that ends level at the floor v0: v0 + V^2/(4 v0) below 2 v0
//   force on the wheel = -N n - Fx e1 - Fy e2,   moment = r x force - Mz n
// so the wrench's power is exactly -(N_H v.n + damping_power + creep_power). N_H v.n is the rate of
// the stored energy 2/5 N_H depth for motion along n over a parabolic gap. Neglected against it is
// the change of the gap's curvature while the contact wanders along the profiles, some percent of
// a stored energy of a few joules.
//
// Elastic rail: a section without mass on a lateral and a vertical spring moves by w with
//   k_y w_y = sum N_H n_y,   k_z w_z = sum N_H n_z
// (Newton with the search in the loop; the sum falls convexly as w grows, so it converges from
// w = 0). Its dampers act on the share of the wheel's velocity that reaches the spring.
#pragma once

#include "rail/contact_search.h"
#include "rail/hertz.h"
#include "rail/wheel_rail.h"

namespace phs::rail {

/// Axes of one patch in C.
struct PatchAxes {
  Vec3 forward;
  Vec3 lateral;
  Vec3 normal;
};

/// The search takes the rail as parallel to x; its slopes (irregularity, twist of a cant ramp) turn
/// the axes, to first order, so that a wheel that follows its rail feels no closing speed and the
/// work of lifting it comes from the forward motion. `slopes`: dy/dx and dz/dx in [1], [2].
PatchAxes AxesOf(double slope, const Vec3& slopes) noexcept;

/// A: half the curvature of the wheel in the rolling direction; the rail is straight [1/m].
double CurvatureAlong(const Overlap& overlap) noexcept;

/// What the force of a patch depends on besides its overlap.
struct ContactForceLaw {
  const WheelRailParams* params = nullptr;
  const CreepLaw* creep = nullptr;
  Hertz hertz{82e9, 0.28};

  /// Adds the patch to `out`.
  void AddPatch(const WheelsetMotion& motion, const Vec3& axle, const Overlap& overlap,
                const PatchAxes& axes, const RailSupport& support,
                WheelRailForces* out) const noexcept;
  /// Overlaps with the rail where its support holds it; `bend` is its displacement w in C.
  void FindOnSupport(const ContactSearch& search, const WheelPlacement& wheel, double rail_y,
                     double rail_z, const RailSupport& support, Vec3* bend,
                     Overlaps* overlaps) const noexcept;
};

}  // namespace phs::rail
