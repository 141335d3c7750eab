// Channels of each cylinder and each line of a PHS.
#include "plugin/channels.h"

namespace phs::plugin {
namespace {

const PhsState& Phs(const Instant& at, ChannelPlace place) {
  return at.phs[static_cast<size_t>(place.index)];
}
size_t Part(ChannelPlace place) { return static_cast<size_t>(place.part); }

constexpr ChannelRow kCylinderRows[] = {
    {"force_N", "N", "tension force",
     [](const Instant& at, ChannelPlace of) { return Phs(at, of).force[Part(of)]; }},
    {"piston_m", "m", "piston displacement, > 0 extension",
     [](const Instant& at, ChannelPlace of) { return Phs(at, of).piston[Part(of)]; }},
    {"friction_N", "N", "friction force",
     [](const Instant& at, ChannelPlace of) { return Phs(at, of).friction_force[Part(of)]; }},
};

constexpr ChannelRow kLineRows[] = {
    {"pressure_Pa", "Pa", "absolute pressure",
     [](const Instant& at, ChannelPlace of) { return Phs(at, of).pressure[Part(of)]; }},
};

}  // namespace

std::span<const ChannelRow> CylinderChannels() { return kCylinderRows; }
std::span<const ChannelRow> LineChannels() { return kLineRows; }

}  // namespace phs::plugin
