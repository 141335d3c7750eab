// Channels of each wheel. Guiding force Y and wheel load Q stand in track axes: Y > 0 = the wheel
// pushes the rail outwards (to the field side), Q > 0 downwards. The force on the rail is minus
// that on the wheel.
#include <cmath>

#include "plugin/channels.h"

namespace phs::plugin {
namespace {

using rail::ContactPatch;
using rail::WheelRailForces;

const WheelRailForces& Wheel(const Instant& at, ChannelPlace place) {
  return at.wheelsets[static_cast<size_t>(place.index)].wheel[place.part];
}

double Y(const WheelRailForces& wheel) { return -wheel.force[1]; }
double Q(const WheelRailForces& wheel) { return -wheel.force[2]; }

/// Creep force of all patches over what friction allows.
double AdhesionUsed(const Instant& at, ChannelPlace place) {
  const WheelRailForces& wheel = Wheel(at, place);
  double used = 0;
  double limit = 0;
  for (int k = 0; k < wheel.count; ++k) {
    const ContactPatch& p = wheel.patch[k];
    used += std::hypot(p.creep.x, p.creep.y);
    limit += p.friction * p.normal;
  }
  return limit > 0 ? used / limit : 0;
}

/// A number of the most loaded patch; 0 without contact.
double OfLargest(const WheelRailForces& wheel, double ContactPatch::*member) {
  double at_largest = 0;
  double load = 0;
  for (int k = 0; k < wheel.count; ++k) {
    if (wheel.patch[k].normal > load) {
      load = wheel.patch[k].normal;
      at_largest = wheel.patch[k].*member;
    }
  }
  return at_largest;
}

double FlangeLoad(const Instant& at, ChannelPlace place) {
  const WheelRailForces& wheel = Wheel(at, place);
  const double flange_angle = at.binding->wheel_rail().params().flange_angle;
  double load = 0;
  for (int k = 0; k < wheel.count; ++k) {
    if (std::abs(wheel.patch[k].angle) > flange_angle) load += wheel.patch[k].normal;
  }
  return load;
}

constexpr ChannelRow kRows[] = {
    {"Y_N", "N", "guiding force, > 0 pushes the rail outwards",
     [](const Instant& at, ChannelPlace of) { return Y(Wheel(at, of)); }},
    {"Q_N", "N", "wheel load", [](const Instant& at, ChannelPlace of) { return Q(Wheel(at, of)); }},
    {"Y_over_Q", "1", "Y/Q",
     [](const Instant& at, ChannelPlace of) {
       const WheelRailForces& wheel = Wheel(at, of);
       return Q(wheel) > 0 ? Y(wheel) / Q(wheel) : 0.0;
     }},
    {"X_N", "N", "longitudinal force of the rail on the wheel, > 0 forward",
     [](const Instant& at, ChannelPlace of) { return Wheel(at, of).force[0]; }},
    {"adhesion_used", "1", "creep force over friction limit, sum over the patches", &AdhesionUsed},
    {"T_gamma_N", "N", "wear number without spin term",
     [](const Instant& at, ChannelPlace of) { return Wheel(at, of).t_gamma; }},
    {"T_gamma_spin_N", "N", "spin term of the wear number",
     [](const Instant& at, ChannelPlace of) { return Wheel(at, of).t_gamma_spin; }},
    {"contacts", "1", "contact patches",
     [](const Instant& at, ChannelPlace of) -> double { return Wheel(at, of).contacts(); }},
    {"contact_angle_rad", "rad", "contact angle of the most loaded patch",
     [](const Instant& at, ChannelPlace of) {
       return OfLargest(Wheel(at, of), &ContactPatch::angle);
     }},
    {"contact_y_m", "m", "position of that patch on the wheel profile",
     [](const Instant& at, ChannelPlace of) {
       return OfLargest(Wheel(at, of), &ContactPatch::wheel_y);
     }},
    {"flange_N", "N", "normal force on flange and flange root (contact steeper than 0.52 rad)",
     &FlangeLoad},
};

}  // namespace

std::span<const ChannelRow> WheelChannels() { return kRows; }

}  // namespace phs::plugin
