// Frames of the rail side and small vectors.
//
// World and track: x forward, y left, z up (MuJoCo's convention). The track frame T at arc length s
// has its origin midway between the rails at rail-top height, x along the centre line, y to the
// left in the (canted) track plane, z normal to that plane.
//
// Canonical wheel frame C: every wheel-rail pair is computed as a *right* wheel in CONTACT's
// convention: x forward, y outward (to the field side), z down. For a right wheel C is T turned by
// pi about x; for a left wheel it is the mirror image. So left and right are one code and mirror
// each other to the last bit:
//            x_C   y_C          z_C    roll_C        pitch_C      yaw_C
//   right    x_T   -y_T         -z_T   roll_T        -pitch_T     -yaw_T
//   left     x_T   +y_T         -z_T   -roll_T       -pitch_T     +yaw_T
// (angles right-handed about x, y, z of their own right-handed frame T; pseudo-vectors such as
// angular velocities and moments transform like the angles).
#pragma once

#include <array>

namespace phs::rail {

using Vec3 = std::array<double, 3>;

inline double Dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

enum class Side { kLeft = 0, kRight = 1 };

/// Components of a polar vector (position, velocity, force) in C from T, and back (an involution).
inline Vec3 MirrorPolar(const Vec3& v, Side side) {
  return {v[0], side == Side::kLeft ? v[1] : -v[1], -v[2]};
}
/// Components of a pseudo-vector (angle, angular velocity, moment) in C from T, and back.
inline Vec3 MirrorAxial(const Vec3& v, Side side) {
  return {side == Side::kLeft ? -v[0] : v[0], -v[1], side == Side::kLeft ? v[2] : -v[2]};
}

}  // namespace phs::rail
