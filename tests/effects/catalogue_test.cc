// The catalogue of effects: its names, its ranges, and wrong input to it.
#include "effects/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "phs_model/phs_model.h"
#include "phs_places.h"
#include "tests/effects/driven_cylinder.h"

namespace phs::effects {

using phs_model::CreatePhsSystem;
namespace {

// Every file of src/effects that describes an effect, <name>.cc with the name as its first word.
std::set<std::string> DescribedEffects() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(PHS_SOURCE_DIR "/src/effects")) {
    std::ifstream file(entry.path());
    std::stringstream text;
    text << file.rdbuf();
    const bool describes = text.str().find("\nconst EffectInfo& ") != std::string::npos;
    if (entry.path().extension() == ".cc" && describes) names.insert(entry.path().stem());
  }
  return names;
}

TEST(Catalogue, HasEachEffectThatAFileDescribesOnce) {
  std::multiset<std::string> rows;
  for (const auto& info : Catalogue().effects()) rows.insert(info.name);
  const std::set<std::string> files = DescribedEffects();
  EXPECT_GT(files.size(), 20u);
  EXPECT_THAT(rows, testing::ElementsAreArray(files));
}

TEST(Catalogue, RangesHoldWhatIsPlausibleAndTheDefault) {
  for (const auto& info : Catalogue().effects()) {
    for (const auto& p : info.parameters) {
      EXPECT_LE(p.min, p.low) << info.name << "." << p.name;
      EXPECT_LE(p.high, p.max) << info.name << "." << p.name;
      EXPECT_TRUE(p.otherwise >= p.min && p.otherwise <= p.max) << info.name << "." << p.name;
    }
  }
}

TEST(Catalogue, UnknownNamesAndKeysGiveTheNearest) {
  const auto wrong = CreatePhsSystem(With(Quarter(), "backlas"));
  ASSERT_FALSE(wrong.ok());
  EXPECT_NE(wrong.error().Line().find("did you mean backlash?"), std::string::npos);
  const auto key = CreatePhsSystem(With(Quarter(), "backlash", {{"gapp_m", 1}}));
  ASSERT_FALSE(key.ok());
  EXPECT_NE(key.error().Line().find("did you mean gap_m?"), std::string::npos);
  const auto range = CreatePhsSystem(With(Quarter(), "backlash", {{"gap_m", -1}}));
  ASSERT_FALSE(range.ok());
  EXPECT_NE(range.error().Line().find("effects.backlash.gap_m"), std::string::npos);
  const auto target = CreatePhsSystem(With(Quarter(), "backlash", {}, {"7"}));
  ASSERT_FALSE(target.ok());
}

}  // namespace
}  // namespace phs::effects
