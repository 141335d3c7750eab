// Manifests by name: every one that ships is known, and named where another is asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "measurement/manifest.h"
#include "phs_places.h"

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

}  // namespace
}  // namespace phs::measurement
