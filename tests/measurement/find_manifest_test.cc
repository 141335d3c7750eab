// Manifests by name: every one that ships is known, and named where another is asked for.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include "measurement/fit_run.h"
#include "measurement/manifest.h"
#include "measurement/rig_data.h"
#include "phs_model/phs_model.h"
#include "phs_places.h"
#include "tests/base/scratch_dir.h"

namespace phs::measurement {
namespace {

namespace fs = std::filesystem;

TEST(FindManifest, KnowsEveryManifestThatShipsAlsoThoseOfTheThesis) {
  const fs::path folder = fs::path(PHS_SOURCE_DIR) / "models/rigs";
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    files.push_back(fs::relative(entry.path(), folder).replace_extension().string());
    EXPECT_TRUE(FindManifest(files.back()).ok()) << files.back();
  }
  EXPECT_GT(files.size(), 30u);
  EXPECT_THAT(ListManifests(), testing::UnorderedElementsAreArray(files));
}

TEST(FindManifest, AWrongNameIsToldWithAllOfThem) {
  const auto fault = [](const std::string& name) { return FindManifest(name).error().Line(); };
  EXPECT_THAT(fault("lowe/fig_6_1"),
              testing::AllOf(testing::HasSubstr("manifest 'lowe/fig_6_1': was not found"),
                             testing::HasSubstr(", lowe/fig_C_5_final, quarter_sine,"),
                             testing::HasSubstr("did you mean 'lowe/fig_6_10'?")));
  EXPECT_THAT(fault("fig_6_10_finl"), testing::HasSubstr("did you mean 'lowe/fig_6_10_final'?"));
  EXPECT_THAT(fault("quarter_sin"), testing::HasSubstr("did you mean 'quarter_sine'?"));
}

std::string LoadingOf(const std::string& text) {
  const ScratchDir dir;
  const auto loaded = LoadManifest(dir.Write("m.yaml", text));
  return loaded.ok() ? "" : loaded.error().Line();
}

TEST(LoadManifest, NoRowIsFittedInOneRunAndJudgesInAnother) {
  const auto runs = [](const std::string& first, const std::string& second) {
    return LoadingOf("rig: quarter\nmodel: quarter_setup2\nruns:\n  - {data: " + first +
                     "}\n  - {data: " + second + "}\n");
  };
  EXPECT_THAT(runs("a.csv, estimation: [0, 28]", "a.csv, validation: [20, 40]"),
              testing::AllOf(testing::HasSubstr("that another is fitted to"),
                             testing::HasSubstr("windows apart")));
  EXPECT_EQ(runs("a.csv, estimation: [0, 28]", "a.csv, validation: [28, 40]"), "");
  EXPECT_EQ(runs("a.csv, estimation: [0, 28]", "b.csv, validation: [20, 40]"), "");
}

TEST(LoadManifest, ALimitOfNothingIsNoLimit) {
  for (const char* key : {"force_N", "speed_m_s"}) {
    const std::string of = std::string("limits: {") + key;
    const std::string rest =
        "rig: quarter\nmodel: quarter_setup2\ndata: a.csv\nestimation: [0, 9]\n";
    EXPECT_THAT(LoadingOf(rest + of + ": 0}\n"), testing::HasSubstr("allowed: x > 0")) << key;
    EXPECT_EQ(LoadingOf(rest + of + ": 1}\n"), "") << key;
  }
}

/// A key that a rig does not read would change nothing in silence.
TEST(LoadManifest, RefusesKeysThatItsRigDoesNotRead) {
  const ScratchDir dir;
  const auto fault = [&](const std::string& lines) {
    const std::string path =
        dir.Write("m.yaml", "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n" + lines);
    const auto m = LoadManifest(path, WindowNeed::kNone);
    return m.ok() ? std::string() : m.error().Line();
  };
  EXPECT_EQ(fault(""), "");
  for (const char* line :
       {"compare_below_Hz: 40", "beam: {lever_m: 1}", "setup: 3", "moving_mass_kg: 50"}) {
    EXPECT_THAT(fault(line), testing::HasSubstr("is not read by rig: quarter")) << line;
  }
  EXPECT_THAT(fault("factors: {load_cell_N: 0}"), testing::HasSubstr("leaves nothing"));
}

/// Names of channels that no rig has are refused with the nearest; a factor of the clock counts.
TEST(ReadRigRun, KnowsItsChannels) {
  const ScratchDir dir;
  std::string rows = "t_s,actuator_m,load_cell_N\n";
  for (int i = 0; i < 100; ++i) rows += std::to_string(i) + ",0,1\n";
  dir.Write("run.csv", rows);
  const auto read = [&](const std::string& lines) {
    const auto m = LoadManifest(
        dir.Write("m.yaml", "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n" + lines),
        WindowNeed::kNone);
    return ReadRigRun(m.value().runs[0], m.value(), {"actuator_m"}, {"load_cell_N"});
  };
  EXPECT_THAT(read("factors: {laod_cell_N: 2}").error().Line(),
              testing::AllOf(testing::HasSubstr("factors.laod_cell_N: no channel"),
                             testing::HasSubstr("did you mean 'load_cell_N'?")));
  EXPECT_THAT(read("columns: {load_cell: load_cell_N}").error().Line(),
              testing::HasSubstr("columns.load_cell: no channel"));
  EXPECT_THAT(read("low_pass_Hz: 0.5").error().Line(), testing::HasSubstr("would change nothing"));
  EXPECT_DOUBLE_EQ(read("").value().step_s, 1.0);
  EXPECT_DOUBLE_EQ(read("factors: {t_s: 0.005}").value().step_s, 0.005);
}

/// A rig of noise and a sine, 30 s at 50 Hz; the rows between 5 and `until` are left out, and the
/// actuator's sensor shows no more than `range_m` to either side.
FitData ReadWithGap(const ScratchDir& dir, double until, const std::string& windows,
                    const std::string& load = "load_cell_N", double range_m = 1) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::string rows = "t_s,actuator_m,piston_m," + load + "\n";
  for (int i = 0; i < 1500; ++i) {
    const double t = 0.02 * i, x = 2e-3 * std::sin(t) * std::min(1.0, t / 3);
    if (t > 5 && t < until) continue;
    const double shown = std::clamp(x + 1e-6 * normal(random), -range_m, range_m);
    rows += fmt::format("{:.2f},{:.9f},{:.9f},{:.3f}\n", t, shown, x + 1e-6 * normal(random),
                        1e7 * x + 30 * normal(random));
  }
  dir.Write("run.csv", rows);
  const auto m = LoadManifest(
      dir.Write("m.yaml", "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n" + windows));
  const auto params = phs_model::FindPhsParams("quarter_setup2");
  const auto data = ReadFitData(m.value(), params.value(), false);
  EXPECT_TRUE(data.ok()) << data.error().Line();
  return data.value();
}

std::string Findings(const FitData& data) {
  std::string all;
  for (const DataFinding& f : data.findings) all += f.channel + " " + f.text + "\n";
  return all;
}

TEST(ReadFitData, AMotionThatIsLongUnknownIsAFault) {
  const ScratchDir dir;
  const std::string windows = "estimation: [0, 20]\nvalidation: [20, 30]\n";
  const FitData lost = ReadWithGap(dir, 7, windows);
  ASSERT_EQ(lost.faults.size(), 1u) << Findings(lost);
  EXPECT_THAT(lost.faults[0], testing::HasSubstr("is not known from 5"));
  EXPECT_TRUE(ReadWithGap(dir, 5.5, windows).faults.empty());
  EXPECT_TRUE(ReadWithGap(dir, 0, windows).faults.empty());
}

// A clipped motion was taken as it stood, and a gain of the piston's sensor named for it.
TEST(ReadFitData, ADrivingMotionAtTheEndOfItsSensorIsAFault) {
  const ScratchDir dir;
  const FitData data =
      ReadWithGap(dir, 0, "estimation: [0, 20]\nvalidation: [20, 30]\n", "load_cell_N", 1.5e-3);
  EXPECT_THAT(Findings(data), testing::HasSubstr("actuator_m saturated at -0.0015 and 0.0015"));
  ASSERT_FALSE(data.faults.empty());
  EXPECT_THAT(data.faults[0], testing::HasSubstr("the driving motion is not known from"));
}

TEST(ReadFitData, SaysWhatItDoesNotTake) {
  const ScratchDir dir;
  const FitData data =
      ReadWithGap(dir, 0, "estimation: [0, 20]\nvalidation: [20, 300]\n", "load_cell_oz");
  EXPECT_THAT(Findings(data), testing::HasSubstr("\"load_cell_oz\" is in no unit that is known"));
  EXPECT_THAT(Findings(data),
              testing::HasSubstr("validation window [20, 300] goes beyond the record"));
  EXPECT_THAT(Findings(ReadWithGap(dir, 0, "estimation: [0, 20]\nvalidation: [20, 30]\n")),
              testing::Not(testing::HasSubstr("beyond the record")));
}

}  // namespace
}  // namespace phs::measurement
