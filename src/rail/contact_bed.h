// Modulus of the bed of springs that stands for the elastic contact, along the rail's surface.
//
// A rail point has a partner: the wheel point that touches it when the upright wheel is moved
// across the rail, from the middle outwards up to the climbing flange. A point that no wheel
// touches first, as between tread and flange root, takes the wheel point that lies opposite when
// the wheel touches on both sides of it. The
// relative curvature 2 B of the two surfaces there, over an arc of a millimetre (a patch averages
// over its own width by itself), and the wheel's curvature 2 A along give K: Hertz's force of the
// pair over the area of its overlap (Hertz::BedModulus). K is then evened out over +-1.5 mm of
// arc, half of a narrow patch, as the integrals need.
//
// K belongs to a place of the rail. So the stored energy changes by what a strip's force does, and
// the force by nothing else than depth.
#pragma once

#include <algorithm>
#include <vector>

#include "rail/hertz.h"
#include "rail/profile.h"

namespace phs::rail {

class ContactBed {
 public:
  /// @param radius of the wheel at its profile's origin [m]
  ContactBed(const Profile& wheel, const Profile& rail, double radius, const Hertz& hertz);
  /// K at a place of the rail profile [Pa].
  double At(double rail_y) const noexcept {
    const double place = std::clamp((rail_y - begin_) * per_step_, 0.0, last_);
    const auto i = static_cast<size_t>(place);
    return bed_[i] + (place - static_cast<double>(i)) * (bed_[i + 1] - bed_[i]);
  }

 private:
  double begin_, per_step_, last_;
  std::vector<double> bed_;
};

}  // namespace phs::rail
