// What verbs print is what stands in their files, and commands that they print can be run.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/table.h"
#include "tests/base/execute.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ToldNumbers : public testing::Test {
 protected:
  /// A sweep of two runs of 50 ms that differ by `axis`, in a folder and of a name with spaces.
  std::string Study(const std::string& axis) const {
    std::filesystem::create_directories(dir_.File("a b"));
    dir_.Write("a b/short.yaml", "track: curve_r550\nspeed_km_h: 50\nduration_s: 0.05\n");
    return dir_.Write("a b/two runs.yaml",
                      "scenario: short.yaml\noutputs: [run.max_sum_Y_N]\naxes:\n"
                      "  - {key: " +
                          axis + "}\n");
  }
  Output Sweep(const std::string& study, const std::string& more = "") const {
    return ExecutePhs("sweep '" + study + "' --quiet --workers 1 --out '" + dir_.File("a b/out") +
                      "' " + more);
  }
  ScratchDir dir_;
};

TEST_F(ToldNumbers, TheMedianOfTwoRunsIsTheirMean) {
  const std::string study = Study("scenario.speed_km_h, values: [40, 60]");
  const Output out = Sweep(study);
  ASSERT_EQ(out.code, 0) << out.text;
  const auto table = ReadCsv(dir_.File("a b/out/sweep.csv"));
  ASSERT_TRUE(table.ok());
  const std::vector<double>& values =
      table.value().columns[static_cast<size_t>(table.value().Find("max_sum_Y_N"))];
  ASSERT_EQ(values.size(), 2u);
  const double mean = 0.5 * (values[0] + values[1]);
  ASSERT_GT(std::abs(values[1] - values[0]), 0.01 * mean);
  EXPECT_THAT(out.text,
              HasSubstr(fmt::format("{:>14.5g}{:>14.5g}{:>14.5g}", std::min(values[0], values[1]),
                                    mean, std::max(values[0], values[1]))));
  const auto held = [&](double at_most) {
    const std::string limits =
        dir_.Write("limits.yaml", fmt::format("limits: [{{quantity: median.run.max_sum_Y_N, "
                                              "at_most: {:.10g}}}]\n",
                                              at_most));
    return Sweep(study, "--force --check " + limits).code;
  };
  EXPECT_EQ(held(mean * 1.001), 0);
  EXPECT_EQ(held(mean * 0.999), 1);
}

TEST_F(ToldNumbers, AReportIsToldWhereThereIsOneAndTheCommandRepeats) {
  const std::string study = Study("scenario.speed_km_h, values: [40, 60]");
  const Output numbers = Sweep(study);
  EXPECT_TRUE(std::filesystem::exists(dir_.File("a b/out/report.html")));
  EXPECT_THAT(numbers.text, HasSubstr("report: " + dir_.File("a b/out/report.html")));
  EXPECT_THAT(numbers.text, HasSubstr("phs sweep '" + study + "' --only RUN --out DIR"));
  const Output words = Sweep(Study("scenario.bogie, values: [phs, rigid_link]"), "--force");
  ASSERT_EQ(words.code, 0) << words.text;
  EXPECT_FALSE(std::filesystem::exists(dir_.File("a b/out/report.html")));
  EXPECT_THAT(words.text, AllOf(HasSubstr("no report: "), Not(HasSubstr("report.html"))));
  const Output only =
      ExecutePhs("sweep '" + study + "' --only 1 --out '" + dir_.File("a b/o") + "'");
  EXPECT_THAT(only.text, HasSubstr("phs simulate '" + dir_.File("a b/o/")));
}

// The lead axle of rigid links points to the outer rail, whichever way the curve turns.
TEST_F(ToldNumbers, RailsOfRightHandCurvesHaveTheirNames) {
  for (const char* track : {"curve_r550", "curve_r550_right"}) {
    const Output out =
        ExecutePhs(std::string("curving --bogies rigid_link --quiet --force --track ") + track +
                   " --out " + dir_.File("curving"));
    ASSERT_EQ(out.code, 0) << out.text;
    EXPECT_THAT(out.text, AllOf(HasSubstr(" outer"), Not(HasSubstr(" inner")))) << track;
    std::ifstream file(dir_.File("curving/curving.json"));
    const auto json = nlohmann::ordered_json::parse(file);
    const auto& row = json["bogies"]["rigid_link"][0];
    const bool left = std::string(track) == "curve_r550";
    EXPECT_EQ(row["hand"], left ? "left" : "right");
    EXPECT_EQ(row["angle_of_attack_lead_rad"].get<double>() < 0, left);
    std::ifstream page(dir_.File("curving/report.html"));
    const std::string html{std::istreambuf_iterator<char>(page), {}};
    EXPECT_THAT(html, AllOf(HasSubstr(" outer<"), Not(HasSubstr(" inner<")))) << track;
  }
}

TEST_F(ToldNumbers, ARadiusOutOfRangeIsRefusedBeforeTheFirstIsSolved) {
  const Output out = ExecutePhs("curving --bogies phs --quiet --radii 300,550,20");
  EXPECT_EQ(out.code, 3);
  EXPECT_THAT(out.text, AllOf(HasSubstr("20 m"), Not(HasSubstr("300"))));
}

// --quiet leaves away progress, not the result.
TEST_F(ToldNumbers, AQuietRigTellsItsResult) {
  const Output out = ExecutePhs("rig quarter_sine --quiet --out " + dir_.File("rig"));
  EXPECT_EQ(out.code, 0);
  EXPECT_THAT(out.text, HasSubstr("load_cell"));
}

TEST_F(ToldNumbers, PathsOfAStudyBeginInItsFolder) {
  std::filesystem::create_directories(dir_.File("own"));
  dir_.Write("own/short.yaml", "track: curve_r550\nspeed_km_h: 50\nduration_s: 0.05\n");
  const std::string study = dir_.Write(
      "own/study.yaml", "question: q\nparts:\n  - {name: one, run: [simulate, short.yaml]}\n");
  const Output out =
      Execute("cd / && " + PhsCommand("study " + study + " --quiet --out " + dir_.File("made")));
  EXPECT_EQ(out.code, 0) << out.text;
}

}  // namespace
}  // namespace phs
