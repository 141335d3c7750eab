// Profiles that are read, but are not what they are given as.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/data_path.h"
#include "base/result_dir.h"
#include "rail/profile.h"

namespace phs::rail {
namespace {

using testing::HasSubstr;

std::string Shipped(const char* name, const char* ending) {
  return ReadFile(FindData("profile", "models/profiles", name, {ending}).value()).value();
}

/// The text with one part replaced.
std::string With(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string ProfileError(const std::string& text, ProfileKind kind) {
  const auto profile = ParseProfile(text, "p", kind);
  return profile.ok() ? "" : profile.error().Line();
}

TEST(ProfileFile, AMirroredWheelIsTold) {
  const std::string wheel = Shipped("S1002", ".prw");
  EXPECT_EQ(ProfileError(wheel, ProfileKind::kWheel), "");
  EXPECT_THAT(
      ProfileError(With(wheel, "mirror.y       =  1", "mirror.y       =  0"), ProfileKind::kWheel),
      HasSubstr("is mirrored: its flange is on the outer side"));
  EXPECT_THAT(
      ProfileError(With(wheel, "mirror.z       =  0", "mirror.z       =  1"), ProfileKind::kWheel),
      HasSubstr("is upside down"));
}

TEST(ProfileFile, ARailUpsideDownIsTold) {
  const std::string rail = Shipped("UIC60", ".prr");
  EXPECT_EQ(ProfileError(rail, ProfileKind::kRail), "");
  EXPECT_THAT(
      ProfileError(With(rail, "mirror.z       =  0", "mirror.z       =  1"), ProfileKind::kRail),
      HasSubstr("is upside down"));
}

TEST(ProfileFile, ASpikeIsTold) {
  std::string rail = "# a flat top\n";
  for (int y = -30; y <= 30; ++y)
    rail += std::to_string(y) + " " + std::to_string(0.01 * y * y) + "\n";
  EXPECT_EQ(ProfileError(rail, ProfileKind::kRail), "");
  EXPECT_THAT(ProfileError(With(rail, "\n10 1.0", "\n10 500.0"), ProfileKind::kRail),
              HasSubstr("p: point 41 lies 499 mm off its neighbours"));
  EXPECT_THAT(ProfileError(With(rail, "\n-30 9.0", "\n-30 900.0"), ProfileKind::kRail),
              HasSubstr("mm tall; allowed: at most 250 mm"));
}

}  // namespace
}  // namespace phs::rail
