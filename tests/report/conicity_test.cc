#include "report/conicity.h"

#include <gtest/gtest.h>

#include "base/result_dir.h"
#include "conicity_pair.h"
#include "holds.h"
#include "report/analysis_report.h"
#include "tests/base/scratch_dir.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;
using testing::Holds;
using testing::Lacks;
using testing::Pair;

std::string PageOf(const std::vector<ConicityOf>& bogies) {
  ReportPage page("Test", "");
  AddConicity(bogies, &page);
  return page.Html();
}

TEST(Conicity, SaysWhatPairItIsOfAndNamesThreeMillimetres) {
  const std::string html =
      PageOf({{"PHS", 0, Pair(1.435, {0.11, 0.12, 0.13, 0.14, 0.1812, 0.19, 0.2})}});
  EXPECT_TRUE(
      Holds(html,
            "Wheel S1002.prw, radius 460.0 mm, flange backs 1360.0 mm apart; rail "
            "UIC60.prr, inclined 1:40 against its file; gauge 1435.0 mm, measured 14.0 mm below"));
  EXPECT_TRUE(Holds(html, "EN 15302:2008, annex B"));
  EXPECT_TRUE(Holds(html, "<th scope=\"row\">3</th><td class=\"strong\">0.181</td>"));
  EXPECT_TRUE(Holds(html, "<th scope=\"row\">1</th><td>0.110</td>"));
  EXPECT_TRUE(Holds(html, "\"x_label\":\"amplitude [mm]\""));
  EXPECT_TRUE(Holds(html, "at 3 mm"));
}

TEST(Conicity, BogiesOnTheSamePairShareACurveAndOthersAreNamed) {
  const json same = Pair(1.435, {0.1, 0.1, 0.1, 0.1, 0.1});
  const std::string one = PageOf({{"PHS", 0, same}, {"rigid link", 1, same}});
  EXPECT_TRUE(Holds(one, "\"label\":\"rigid bodies\""));
  EXPECT_TRUE(Lacks(one, "PHS"));
  const std::string two =
      PageOf({{"PHS", 0, same}, {"rigid link", 1, Pair(1.067, {0.2, 0.2, 0.2, 0.2, 0.2}, 6e4)}});
  EXPECT_TRUE(Holds(two, "\"label\":\"PHS: rigid bodies\""));
  EXPECT_TRUE(Holds(two, "\"label\":\"rigid link: elastic, 60.0 kN on each wheel\""));
  EXPECT_TRUE(Holds(two, "gauge 1067.0 mm"));
}

TEST(Conicity, NothingIsDroppedSilently) {
  const std::string none =
      PageOf({{"PHS", 0, {{"missing", "this run has no wheel and rail profiles"}}},
              {"rigid link", 1, Pair(1.435, {0.1, 0.1, 0.1, 0.1, 0.1})},
              {"soft link", 2, json()}});
  EXPECT_TRUE(
      Holds(none, "There is no conicity curve of PHS: this run has no wheel and rail profiles."));
  EXPECT_TRUE(Holds(none, "There is no conicity curve of soft link: it was not kept"));
  EXPECT_TRUE(Holds(none, "\"label\":\"rigid link: rigid bodies\""));
}

TEST(Conicity, SteadyCurvingShowsItToo) {
  const ScratchDir dir;
  const std::string file = dir.Write(
      "curving.json", json{{"bogies", {{"phs", json::array()}}},
                           {"conicity", {{"phs", Pair(1.435, {0.1, 0.1, 0.1, 0.1, 0.15})}}}}
                          .dump());
  ASSERT_TRUE(WriteSteadyCurvingReport(file, dir.File("report.html")).ok());
  const std::string html = ReadFile(dir.File("report.html")).value();
  EXPECT_TRUE(Holds(html, "<th scope=\"row\">3</th><td class=\"strong\">0.150</td>"));
}

}  // namespace
}  // namespace phs::report
