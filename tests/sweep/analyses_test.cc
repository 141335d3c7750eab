// Every analysis that a study can ask for: docs/sweep_optimise.md names it, and what it says of
// itself is so.
#include "sweep/analyses.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "base/json_path.h"
#include "vehicle/scenario_file.h"

namespace phs::sweep {
namespace {

const std::string kDocument = std::string(PHS_SOURCE_DIR) + "/docs/sweep_optimise.md";
const std::string kBegin =
    "<!-- analyses: written by PHS_WRITE_DOCS=1 test_sweep --gtest_filter=AnalysesDoc.* -->\n";
const std::string kEnd = "<!-- /analyses -->";

std::string Document() {
  std::ifstream file(kDocument);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string AnalysesText() {
  std::string text = "| `analysis` | results (paths as in the JSON of the verb) |\n|---|---|\n";
  for (const Analysis& a : Analyses()) text += fmt::format("| `{}` | {} |\n", a.name, a.text);
  return text;
}

TEST(AnalysesDoc, HasEveryAnalysisAsTheTableSaysIt) {
  std::string document = Document();
  const size_t begin = document.find(kBegin), end = document.find(kEnd);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const size_t from = begin + kBegin.size();
  if (std::getenv("PHS_WRITE_DOCS") != nullptr) {
    std::ofstream(kDocument) << document.replace(from, end - from, AnalysesText());
    document = Document();
  }
  EXPECT_EQ(document.substr(from, document.find(kEnd) - from), AnalysesText())
      << "write it anew: see the comment in docs/sweep_optimise.md";
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
