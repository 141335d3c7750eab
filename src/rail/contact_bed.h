// Modulus of the bed of springs that stands for the elastic contact, along the rail's surface.
//
// A rail point touches the wheel where the slopes agree, so it knows its partner in the upright
// wheelset, and their relative curvature across 2 B: the mean over +- 3 mm of both surfaces, the
// width of a patch, as arcs have jumps of curvature that a patch does not feel. Hertz's force of
// this pair on the area of its overlap gives K (Hertz::BedModulus), evened out over the same width.
// A wheelset that rolls by some milliradians (the other wheel climbs) meets other partners; K is
// then up to a third off and the approach a few micrometres, the force under a load not at all.
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
