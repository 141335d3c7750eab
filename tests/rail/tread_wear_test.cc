#include "rail/tread_wear.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/data_path.h"
#include "rail/wheel_rail.h"

namespace phs::rail {
namespace {

Profile Wheel() {
  return LoadProfile(FindData("profile", "models/profiles", "S1002", {".prw"}).value(),
                     ProfileKind::kWheel)
      .value();
}

WheelRailParams Params(double depth_m) {
  WheelRailParams p;
  p.wheel_profile = FindData("profile", "models/profiles", "S1002", {".prw"}).value();
  p.rail_profile = FindData("profile", "models/profiles", "UIC60", {".prr"}).value();
  p.wear.depth_m = depth_m;
  return p;
}

/// Rolling radius of the right wheel less that of the left at a shift to the right.
double RadiusDifference(const WheelRail& contact, double shift) {
  return contact.Touch(shift, 0, 0).radius - contact.Touch(-shift, 0, 0).radius;
}

TEST(TreadWearTest, TakesARaisedCosineOffTheTread) {
  const Profile before = Wheel();
  Profile after = before;
  const TreadWear wear{0.002, 0.03, 0.004};
  WearTread(wear, &after);
  for (const double u : {-1.5, -1.0, -0.5, 0.0, 0.5, 1.0}) {
    const double y = wear.centre_m + u * wear.half_width_m;
    if (y < before.min_y() || y > before.max_y()) continue;
    const double depth = std::abs(u) < 1 ? 0.001 * (1 + std::cos(M_PI * u)) : 0;
    EXPECT_NEAR(before.At(y).z - after.At(y).z, depth, 1e-5) << u;
  }
  // Inside of the trough's middle the tread falls more steeply outwards, outside less.
  EXPECT_LT(after.At(0.004 - 0.015).slope, before.At(0.004 - 0.015).slope - 0.08);
  EXPECT_GT(after.At(0.004 + 0.015).slope, before.At(0.004 + 0.015).slope + 0.08);
}

TEST(TreadWearTest, NoWearLeavesEveryBit) {
  const Profile before = Wheel();
  Profile after = before;
  WearTread({0, 0.04, 0.01}, &after);
  for (double y = before.min_y(); y < before.max_y(); y += 1e-3) {
    EXPECT_EQ(before.At(y).z, after.At(y).z);
  }
}

TEST(TreadWearTest, HollowTreadHasMoreConicity) {
  double last = 0;
  for (const double depth : {0.0, 0.1e-3, 0.2e-3, 0.3e-3}) {
    const auto contact = WheelRail::Create(Params(depth));
    ASSERT_TRUE(contact.ok()) << contact.error().Line();
    const double difference = RadiusDifference(contact.value(), 3e-3);
    EXPECT_GT(difference, last) << depth;
    last = difference;
  }
}

TEST(TreadWearTest, NamesWhatIsOutOfRange) {
  for (const TreadWear& wear :
       {TreadWear{0.006, 0.03, 0}, TreadWear{0.001, 0.005, 0}, TreadWear{0.001, 0.03, 0.05}}) {
    EXPECT_FALSE(Validate(wear).ok());
  }
  const auto contact = WheelRail::Create(Params(0.02));
  ASSERT_FALSE(contact.ok());
  EXPECT_NE(contact.error().Line().find("depth_m"), std::string::npos);
}

}  // namespace
}  // namespace phs::rail
