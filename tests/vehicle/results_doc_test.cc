// docs/results.md lists every recorded channel as the tables of the program have it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "plugin/channels.h"
#include "vehicle/energy_channels.h"

namespace phs::vehicle {
namespace {

const std::string kDocument = std::string(PHS_SOURCE_DIR) + "/docs/results.md";
const std::string kBegin =
    "<!-- channels: written by PHS_WRITE_DOCS=1 test_vehicle --gtest_filter=ResultsDoc.* -->\n";
const std::string kEnd = "<!-- /channels -->";

std::string Document() {
  std::ifstream file(kDocument);
  return {std::istreambuf_iterator<char>(file), {}};
}

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
  std::string document = Document();
  const size_t begin = document.find(kBegin), end = document.find(kEnd);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const size_t from = begin + kBegin.size();
  if (std::getenv("PHS_WRITE_DOCS") != nullptr) {
    std::ofstream(kDocument) << document.replace(from, end - from, ChannelsText());
    document = Document();
  }
  EXPECT_EQ(document.substr(from, document.find(kEnd) - from), ChannelsText())
      << "write it anew: see the comment in docs/results.md";
}

}  // namespace
}  // namespace phs::vehicle
