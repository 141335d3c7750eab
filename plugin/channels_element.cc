// Channels of each element between bodies that is made here (elements.h).
#include "plugin/channels.h"

namespace phs::plugin {
namespace {

ElementState State(const Instant& at, ChannelPlace place) {
  const Elements& elements = *at.binding->elements()[static_cast<size_t>(place.index)];
  return elements.StateOf(at.m, at.d, at.binding->Speed(at.d), place.part);
}

constexpr ChannelRow kRows[] = {
    {"force_N", "N", "force along it, > 0 pushes its ends apart",
     [](const Instant& at, ChannelPlace of) { return State(at, of).force; }},
    {"length_m", "m", "distance of its ends",
     [](const Instant& at, ChannelPlace of) { return State(at, of).length; }},
    {"speed_m_s", "m/s", "rate of that distance",
     [](const Instant& at, ChannelPlace of) { return State(at, of).speed; }},
};

}  // namespace

std::span<const ChannelRow> ElementChannels() { return kRows; }

}  // namespace phs::plugin
