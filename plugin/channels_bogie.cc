// Channels of each pair of wheelsets in one frame.
#include "plugin/channels.h"

namespace phs::plugin {
namespace {

/// Yaw of lead and trail against the frame.
struct Yaws {
  double lead = 0;
  double trail = 0;
};
Yaws YawsOf(const Instant& at, ChannelPlace place) {
  const BogiePair& bogie = (*at.bogies)[static_cast<size_t>(place.index)];
  const std::vector<WheelsetBinding>& wheelsets = at.binding->wheelsets();
  return {at.Joint(wheelsets[static_cast<size_t>(bogie.lead)].yaw_joint),
          at.Joint(wheelsets[static_cast<size_t>(bogie.trail)].yaw_joint)};
}

constexpr ChannelRow kRows[] = {
    {"bending_rad", "rad", "yaw of lead minus yaw of trail against the frame",
     [](const Instant& at, ChannelPlace of) {
       const Yaws yaw = YawsOf(at, of);
       return yaw.lead - yaw.trail;
     }},
    {"shear_rad", "rad", "mean yaw of both axles against the frame",
     [](const Instant& at, ChannelPlace of) {
       const Yaws yaw = YawsOf(at, of);
       return (yaw.lead + yaw.trail) / 2;
     }},
};

}  // namespace

std::span<const ChannelRow> BogieChannels() { return kRows; }

}  // namespace phs::plugin
