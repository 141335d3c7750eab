// Channels of the run as a whole.
#include "plugin/channels.h"

namespace phs::plugin {
namespace {

/// Of its centre of mass, own axes.
rail::Vec3 CarBodyVelocity(const Instant& at) {
  const rail::Vec3 velocity = at.binding->CentreOfMassVelocity(at.m, at.d, at.car_body);
  rail::Vec3 own;
  mju_rotVecMatT(own.data(), velocity.data(), at.d->ximat + 9 * at.car_body);
  return own;
}

constexpr ChannelRow kRows[] = {
    {"t_s", "s", "time",
     [](const Instant& at, ChannelPlace) { return at.d->userdata[UserData::kTime]; }},
    {"s_m", "m", "arc length of the leading wheelset",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->frame.s : 0; }},
    {"speed_m_s", "m/s", "speed along the track",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->speed : 0; }},
    {"curvature_1_m", "1/m", "of the track under the leading wheelset, > 0 left",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->frame.curvature : 0; }},
    {"cant_rad", "rad", "of the track under the leading wheelset, > 0 right rail raised",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->frame.cant : 0; }},
    {"car_body_lateral_speed_m_s", "m/s", "of its centre of mass, own axes, > 0 left",
     [](const Instant& at, ChannelPlace) { return CarBodyVelocity(at)[1]; }},
    {"car_body_vertical_speed_m_s", "m/s", "of its centre of mass, own axes, > 0 up",
     [](const Instant& at, ChannelPlace) { return CarBodyVelocity(at)[2]; }},
};

}  // namespace

std::span<const ChannelRow> RunChannels() { return kRows; }

}  // namespace phs::plugin
