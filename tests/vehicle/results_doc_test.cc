// docs/results.md lists every recorded channel as the tables of the program have it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "plugin/channels.h"
#include "tests/base/page_section.h"
#include "vehicle/energy_channels.h"

namespace phs::vehicle {
namespace {

template <typename Row>
std::string Line(const char* kind, const std::string& prefix, const Row& row) {
  return fmt::format("| {} | `{}{}` | {} | {} |\n", kind, prefix, row.name, row.unit, row.text);
}

std::string ChannelsText() {
  std::string text = "| of | channel | unit | |\n|---|---|---|---|\n";
  for (const plugin::ChannelKind& kind : plugin::ChannelKinds()) {
    for (const plugin::ChannelRow& row : kind.rows) text += Line(kind.name, kind.prefix, row);
  }
  for (const EnergyRow& row : EnergyChannels()) text += Line("run", "", row);
  return text;
}

TEST(ResultsDoc, HasEveryChannelAsTheTablesSayIt) {
  ExpectPageSection("results.md", "channels", ChannelsText());
}

}  // namespace
}  // namespace phs::vehicle
