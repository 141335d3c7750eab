// What the overlap of wheel and rail is worth as elastic energy, along the rail's surface.
//
// A patch stores U with U^(9/5) = int kappa g^4 ds, g the depth of the overlap along the normal, s
// the arc across the rail (contact_search.h). Two parabolas g = d - B s^2 give
//   int g^4 ds = d^(9/2)/sqrt(B) I,   I = int_-1^1 (1 - u^2)^4 du = 256/315,
// and Hertz stores 2/5 k d^(5/2), k(A, B) his force over d^(3/2). So
//   kappa = (2/5 k)^(9/5) sqrt(B)/I.
// It varies little with B.
//
// A rail point has a partner: the wheel point that touches it when the upright wheel is moved
// across the rail, from the middle outwards up to the climbing flange. A point that no wheel
// touches first, as between tread and flange root, takes the wheel point that lies opposite when
// the wheel touches on both sides of it. The relative curvature 2 B of the two surfaces there, over
// an arc of a millimetre (a patch averages over its own width by itself), and the wheel's curvature
// 2 A along give kappa, which is then evened out over +-1.5 mm of arc, half of a narrow patch, as
// the integrals need.
//
// kappa belongs to a place of the rail. So the stored energy changes by what the forces do.
#pragma once

#include <algorithm>
#include <vector>

#include "rail/hertz.h"
#include "rail/profile.h"

namespace phs::rail {

/// int_-1^1 (1 - u^2)^4 du.
inline constexpr double kParabolaFourth = 256.0 / 315;

class ContactModulus {
 public:
  /// @param radius of the wheel at its profile's origin [m]
  ContactModulus(const Profile& wheel, const Profile& rail, double radius, const Hertz& hertz);
  /// kappa at a place of the rail profile [J^(9/5)/m^5].
  double At(double rail_y) const noexcept {
    const double place = std::clamp((rail_y - begin_) * per_step_, 0.0, last_);
    const auto i = static_cast<size_t>(place);
    return modulus_[i] + (place - static_cast<double>(i)) * (modulus_[i + 1] - modulus_[i]);
  }

 private:
  double begin_, per_step_, last_;
  std::vector<double> modulus_;
};

}  // namespace phs::rail
