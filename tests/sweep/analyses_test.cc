// Every analysis that a study can ask for: docs/sweep_optimise.md names it, and what it says of
// itself is so.
#include "sweep/analyses.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "base/json_path.h"
#include "phs_places.h"
#include "tests/base/page_section.h"

namespace phs::sweep {
namespace {

std::string AnalysesText() {
  std::string text = "| `analysis` | results (paths as in the JSON of the verb) |\n|---|---|\n";
  for (const Analysis& a : Analyses()) text += fmt::format("| `{}` | {} |\n", a.name, a.text);
  return text;
}

TEST(AnalysesDoc, HasEveryAnalysisAsTheTableSaysIt) {
  ExpectPageSection("sweep_optimise.md", "analyses", AnalysesText());
}

TEST(AnalysesTest, EveryAnalysisHasTheOutputsThatItNamesFirst) {
  for (const Analysis& analysis : Analyses()) {
    const std::string base = std::string(analysis.of) == "rig"           ? "rigs/quarter_sine"
                             : std::string(analysis.name) == "stability" ? "scenarios/straight"
                                                                         : "scenarios/curve_r550";
    const std::string file = PHS_SOURCE_DIR "/models/" + base + ".yaml";
    const auto made =
        analysis.names != nullptr ? analysis.names(file, analysis.outputs) : analysis.run(file);
    ASSERT_TRUE(made.ok()) << analysis.name << ": " << made.error().Line();
    for (const std::string& path : analysis.outputs) {
      EXPECT_TRUE(NumberAt(made.value().numbers, path).ok()) << analysis.name << ": " << path;
    }
  }
}

}  // namespace
}  // namespace phs::sweep
