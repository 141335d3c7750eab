// The linear wheel-rail contact of the classic stability papers, for one wheel: given conicity,
// creep coefficients and contact stiffness instead of profiles and a theory of contact. Frame C
// (frames.h): right wheel, x forward, y outward, z down; left wheels are mirrored by the caller.
//
// The contact plane stays horizontal at the half base a: the wheelset neither rolls nor lifts as it
// shifts, so there is no gravitational stiffness. With y the outward shift of the wheelset:
//   rolling radius   r = r0 + lambda y
//   creepages        xi = -v_x/V,  eta = -v_y/V,  phi = -omega_z/V   of the wheel's contact point
//   creep on the rail  x = -f11 xi,  y = -f22 eta - f23 phi,  moment = +f23 eta - f33 phi
//   saturation (limit > 0), L = |(f11 xi, f22 eta)|, u = L/limit: x and y times
//     (1 - u/3 + u^2/27) for u < 3, limit/L beyond          (Vermeulen and Johnson, 1964)
//   vertical         N = N0 + k d + c d',  d = z + a roll + r0: linear, so it may pull
//   flange           inward force k_f (y - clearance) for y > clearance
// For a whole wheelset at small motion this is the textbook pair (Wickens, Fundamentals of Rail
// Vehicle Dynamics, 2003, chapter 2):
//   F_y = -2 f22 (y'/V - psi),   M_z = -2 f11 a (a psi'/V + lambda y/r0).
#pragma once

#include "base/result.h"
#include "rail/wheel_contact.h"

namespace phs::rail {

/// Checks the ranges given in wheel_rail.h; the error names the parameter.
Status Validate(const LinearContactParams& params);

/// Force and motion of one wheel. `radius` r0 [m]; `speed_floor` as in WheelRailParams. `damping`
/// may be null.
void CalcLinearContact(const LinearContactParams& params, double radius, double speed_floor,
                       const WheelsetMotion& motion, WheelRailForces* out,
                       WheelDamping* damping = nullptr) noexcept;

}  // namespace phs::rail
