#include "rail/contact_functions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contact_pair.h"

namespace phs::rail {
namespace {

// A coned wheelset on round rails of radius R rolls as it moves aside, so it runs as a cone of
//   lambda (b + R lambda)/(b - r0 lambda)
// (Wickens, Fundamentals of Rail Vehicle Dynamics, 2003, section 2.3), at every amplitude.
TEST(ContactFunctions, AConeHasItsOwnConicity) {
  for (const char* cone : {"cone:0.05", "cone:0.1"}) {
    const double lambda = std::stod(std::string(cone).substr(5));
    WheelRailParams p = StandardPair();
    p.wheel_profile = cone;
    p.rail_profile = "arc:0.3";
    const WheelRail wheel = Create(p);
    const auto f = CalcContactFunctions(wheel, wheel, 10e-3, 0.2e-3);
    ASSERT_TRUE(f.ok()) << f.error().Line();
    EXPECT_NEAR(f.value().centre, 0, 1e-9);
    const double wickens = lambda * (0.75 + 0.3 * lambda) / (0.75 - 0.46 * lambda);
    EXPECT_GT(f.value().conicity.size(), 5u);
    for (const Conicity& c : f.value().conicity) EXPECT_NEAR(c.value / wickens, 1, 5e-3);
    for (const ContactFunctionRow& row : f.value().rows) {
      EXPECT_NEAR(row.RadiusDifference(), 2 * wickens * row.y, 5e-3 * 2 * lambda * 10e-3);
    }
  }
}

// How far the functions reach must not move the waves inside: each is that of its own amplitude.
TEST(ContactFunctions, ConicityIsThatOfItsAmplitudeAndNotOfAnother) {
  const WheelRail wheel = Create(StandardPair());
  const auto fine = CalcContactFunctions(wheel, wheel, 6e-3, 0.05e-3, 80e3);
  const auto other = CalcContactFunctions(wheel, wheel, 7e-3, 0.05e-3, 80e3);
  ASSERT_TRUE(fine.ok() && other.ok());
  ASSERT_GE(fine.value().conicity.size(), 9u);
  for (size_t i = 0; i < 9; ++i) {
    EXPECT_NEAR(fine.value().conicity[i].amplitude, 1e-3 + 0.5e-3 * static_cast<double>(i), 1e-12);
    EXPECT_NEAR(fine.value().conicity[i].value / other.value().conicity[i].value, 1, 1e-6) << i;
  }
}

// Near a flange three rolls let both wheels touch: on S1002/UIC60 at 1067 mm and y = 5.5 mm 0.7 mrad, 3.0
// mrad and 14.6 mrad, found by a scan of the heights over the roll. A wheelset that moves out from the middle
// has the first, until it ends at 5.95 mm.
TEST(ContactFunctions, TheRollGoesOnFromTheMiddle) {
  WheelRailParams p = StandardPair();
  p.gauge = 1.067;
  p.flange_back_distance = 0.992;
  p.wheel_radius = 0.625;
  const WheelRail wheel = Create(p);
  for (const double load : {0.0, 80e3}) {
    const auto f = CalcContactFunctions(wheel, wheel, 5.9e-3, 0.1e-3, load);
    ASSERT_TRUE(f.ok()) << f.error().Line();
    ASSERT_EQ(f.value().rows.size(), 119u);
    for (const ContactFunctionRow& row : f.value().rows) {
      EXPECT_LT(std::abs(row.roll), 1.1e-3) << row.y << " " << load;
      EXPECT_LT(row.roll * row.y, 1e-12) << row.y;
    }
  }
  const auto apart = [&](double roll) {
    return wheel.Touch(-5.5e-3, -roll, 0).height - wheel.Touch(5.5e-3, roll, 0).height;
  };
  int changes = 0;
  for (double roll = -0.03; roll < 0; roll += 1e-4) {
    if ((apart(roll) < 0) != (apart(roll + 1e-4) < 0)) ++changes;
  }
  EXPECT_EQ(changes, 3);
}

TEST(ContactFunctions, TheSamePairOnBothSidesIsOdd) {
  const WheelRail wheel = Create(StandardPair());
  const auto result = CalcContactFunctions(wheel, wheel, 8e-3, 0.25e-3);
  ASSERT_TRUE(result.ok());
  const auto& rows = result.value().rows;
  ASSERT_EQ(rows.size(), 65u);
  for (size_t i = 0; i < rows.size(); ++i) {
    const ContactFunctionRow& a = rows[i];
    const ContactFunctionRow& b = rows[rows.size() - 1 - i];
    EXPECT_NEAR(a.roll, -b.roll, 1e-9);
    EXPECT_NEAR(a.right.radius, b.left.radius, 1e-6);
    EXPECT_NEAR(a.right.angle, b.left.angle, 1e-4);
  }
}

// S1002 on UIC60 1:40, 1435 mm: about 0.18 at 3 mm is the usual figure for new profiles.
TEST(ContactFunctions, S1002OnUic60HasItsUsualConicity) {
  WheelRailParams p = StandardPair();
  const WheelRail wheel = Create(p);
  const auto f = CalcContactFunctions(wheel, wheel, 8e-3, 0.05e-3);
  ASSERT_TRUE(f.ok());
  ASSERT_GT(f.value().conicity.size(), 4u);
  EXPECT_NEAR(f.value().conicity[4].amplitude, 3e-3, 1e-9);
  EXPECT_NEAR(f.value().conicity[4].value, 0.18, 0.01);
}

}  // namespace
}  // namespace phs::rail
