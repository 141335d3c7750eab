// Channels of the run as a whole.
#include <array>

#include "plugin/channels.h"

namespace phs::plugin {
namespace {

/// Velocity of the car body's centre of mass in its own axes: rotation, then translation.
std::array<mjtNum, 6> CarBodyVelocity(const Instant& at) {
  std::array<mjtNum, 6> velocity;
  mj_objectVelocity(at.m, at.d, mjOBJ_BODY, at.car_body, velocity.data(), 1);
  return velocity;
}

constexpr ChannelRow kRows[] = {
    // Steps of a run are named after the state they start from.
    {"t_s", "s", "time", [](const Instant& at, ChannelPlace) { return at.d->time; }},
    {"s_m", "m", "arc length of the leading wheelset",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->frame.s : 0; }},
    {"speed_m_s", "m/s", "speed along the track",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->speed : 0; }},
    {"curvature_1_m", "1/m", "of the track under the leading wheelset, > 0 left",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->frame.curvature : 0; }},
    {"cant_rad", "rad", "of the track under the leading wheelset, > 0 right rail raised",
     [](const Instant& at, ChannelPlace) { return at.leading ? at.leading->frame.cant : 0; }},
    {"car_body_lateral_speed_m_s", "m/s", "of its centre of mass, own axes, > 0 left",
     [](const Instant& at, ChannelPlace) { return CarBodyVelocity(at)[4]; }},
    {"car_body_vertical_speed_m_s", "m/s", "of its centre of mass, own axes, > 0 up",
     [](const Instant& at, ChannelPlace) { return CarBodyVelocity(at)[5]; }},
};

}  // namespace

std::span<const ChannelRow> RunChannels() { return kRows; }

}  // namespace phs::plugin
