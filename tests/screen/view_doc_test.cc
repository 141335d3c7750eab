// docs/view.md lists keys and cameras as the tables of the program have them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "screen/player.h"
#include "tests/base/page_section.h"
#include "view/camera.h"

namespace phs::screen {
namespace {

TEST(ViewDoc, HasEveryKey) {
  std::string text = "| key | |\n|---|---|\n";
  for (const KeyRow& row : Keys()) text += fmt::format("| {} | {} |\n", row.name, row.text);
  ExpectPageSection("view.md", "keys", text);
}

TEST(ViewDoc, HasEveryCamera) {
  std::string text = "| camera | |\n|---|---|\n";
  for (const view::View& view : view::Views()) {
    text += fmt::format("| `{}` | {} |\n", view.name, view.text);
  }
  ExpectPageSection("view.md", "cameras", text);
}

}  // namespace
}  // namespace phs::screen
