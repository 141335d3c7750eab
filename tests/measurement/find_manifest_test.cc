// Manifests by name: every one that ships is known, and named where another is asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "measurement/manifest.h"
#include "measurement/rig_data.h"
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
  EXPECT_DOUBLE_EQ(read("").value().step_s, 1.0);
  EXPECT_DOUBLE_EQ(read("factors: {t_s: 0.005}").value().step_s, 0.005);
}

}  // namespace
}  // namespace phs::measurement
