// Every analysis that a study can ask for: docs/sweep_optimise.md names it, and what it says of
// itself is so.
#include "sweep/analyses.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "base/json_path.h"
#include "tests/base/page_section.h"
#include "vehicle/scenario_file.h"

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
  const auto scenario = vehicle::LoadScenario("curve_r550");
  ASSERT_TRUE(scenario.ok());
  for (const Analysis& analysis : Analyses()) {
    const bool on_straight = std::string(analysis.name) == "stability";
    vehicle::Scenario own = scenario.value();
    if (on_straight) own.track = "straight";
    const auto made =
        analysis.names != nullptr ? analysis.names(own, analysis.outputs) : analysis.run(own);
    ASSERT_TRUE(made.ok()) << analysis.name << ": " << made.error().Line();
    for (const std::string& path : analysis.outputs) {
      EXPECT_TRUE(NumberAt(made.value().numbers, path).ok()) << analysis.name << ": " << path;
    }
  }
}

}  // namespace
}  // namespace phs::sweep
