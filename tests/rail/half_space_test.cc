// Contact under a wheel load against elastic half-spaces: where the load lies on a centred
// wheelset, and so what conicity a wheelset feels that is pressed, not only laid, on its rails.
#include "tests/rail/half_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rail/contact_functions.h"
#include "rail/hertz.h"
#include "rail/profile.h"
#include "tests/rail/contact_pair.h"

namespace phs::rail {
namespace {

constexpr double kShear = 82e9;
constexpr double kPoisson = 0.28;
constexpr double kCompliance = (1 - kPoisson) / (std::numbers::pi * kShear);
constexpr double kAxleLoad = 127.5e3;  ///< of a 26 t axle [N]

TEST(HalfSpaceTest, TwoParabolasGiveHertzsPeakPressure) {
  const double along = 0.8;
  const double across = 1.5;
  HalfSpace space(14, 36, 0.6e-3, 0.4e-3, 0, kCompliance);
  space.Solve([&](double x, double y) { return along * x * x + across * y * y; }, kAxleLoad);
  const HertzContact hertz = Hertz(kShear, kPoisson).UnderLoad(kAxleLoad, along, across);
  EXPECT_NEAR(space.Peak() / hertz.peak_pressure, 1, 0.01);
  EXPECT_NEAR(space.Mean([](double y) { return y; }), 0, 1e-9);
}

/// 1067 mm gauge, 1250 mm wheels: the bogies of this product.
WheelRailParams CapeGauge() {
  WheelRailParams p = StandardPair();
  p.gauge = 1.067;
  p.flange_back_distance = 0.992;
  p.wheel_radius = 0.625;
  return p;
}

/// Of a right wheel at lateral shift y without roll.
struct PatchLoad {
  double wheel_y = 0;  ///< centre of the load on the wheel profile [m]
  double radius = 0;   ///< of the wheel, mean over the load [m]
};

PatchLoad ByHalfSpace(const WheelRailParams& p, double y, double load = kAxleLoad) {
  auto wheel = LoadProfile(p.wheel_profile, ProfileKind::kWheel).value();
  auto rail = LoadProfile(p.rail_profile, ProfileKind::kRail).value();
  rail.PutTopAtZero();
  const double rail_y = p.gauge / 2 - rail.InnerSideAtDepth(p.gauge_height);
  const double shift = p.flange_back_distance / 2 - p.flange_back_position + y - rail_y;
  const auto gap = [&](double x, double at) {
    const double z = wheel.At(at - shift).z;
    return rail.At(at).z - z + x * x / (2 * (p.wheel_radius + z));
  };
  // From the field side to the gauge corner: 4 mm outwards the load reaches 31 mm inwards.
  HalfSpace space(12, 90, 1e-3, 0.6e-3, -16e-3, kCompliance);
  space.Solve(gap, load);
  const double centre = space.Mean([](double at) { return at; }) - shift;
  const double height = space.Mean([&](double at) { return wheel.At(at - shift).z; });
  return {centre, p.wheel_radius + height};
}

PatchLoad Own(const WheelRail& pair, double y, double load = kAxleLoad) {
  WheelsetMotion motion;
  motion.lateral = y;
  motion.speed = 20;
  motion.velocity = {20, 0, 0};
  double low = pair.touching_height() - 2e-3;
  double high = low + 6e-3;
  WheelRailForces f;
  for (int i = 0; i < 50; ++i) {
    motion.vertical = 0.5 * (low + high);
    pair.Calc(motion, Side::kRight, {}, {}, &f);
    (-f.force[2] < load ? low : high) = motion.vertical;
  }
  PatchLoad centre;
  double sum = 0;
  for (int i = 0; i < f.count; ++i) {
    const ContactPatch& patch = f.patch[static_cast<size_t>(i)];
    centre.wheel_y += patch.normal * patch.wheel_y;
    centre.radius += patch.normal * patch.rolling_radius;
    sum += patch.normal;
  }
  return {centre.wheel_y / sum, centre.radius / sum};
}

TEST(HalfSpaceTest, LoadWandersAcrossTheWheelAsOnElasticBodies) {
  // Rigid bodies jump from tread to flange root 0.25 mm beside the centre; under load both places
  // bear and the load's centre wanders over 27 mm of the wheel. Independent springs would have it
  // up to 1.4 mm and the radius 0.14 mm off.
  const WheelRail pair = Create(CapeGauge());
  for (const double load : {60e3, kAxleLoad, 150e3}) {
    for (const double y : {-4e-3, -2e-3, -1e-3, -0.25e-3, 0.0, 0.25e-3, 1e-3, 2e-3, 4e-3}) {
      const PatchLoad reference = ByHalfSpace(CapeGauge(), y, load);
      const PatchLoad own = Own(pair, y, load);
      EXPECT_NEAR(own.wheel_y, reference.wheel_y, 0.4e-3) << "y = " << y << ", " << load;
      EXPECT_NEAR(own.radius, reference.radius, 0.045e-3) << "y = " << y << ", " << load;
    }
  }
}

TEST(HalfSpaceTest, AWheelInATightCurveFindsItsRadiusWithinAQuarterMillimetreOfElasticBodies) {
  // Where the load goes over to the flange root the radius rises by 0.4 to 2.5 per shift: what
  // counts is how far aside of the reference a wheel has the radius that it needs.
  const WheelRail pair = Create(CapeGauge());
  constexpr double kStep = 0.25e-3;
  double before = ByHalfSpace(CapeGauge(), 3.5e-3, 150e3).radius;
  for (double y = 3.75e-3; y < 5.8e-3; y += kStep) {
    const double reference = ByHalfSpace(CapeGauge(), y, 150e3).radius;
    const double rise = (reference - before) / kStep;
    EXPECT_NEAR((Own(pair, y, 150e3).radius - reference) / rise, 0, 0.25e-3) << "y = " << y;
    before = reference;
  }
}

TEST(HalfSpaceTest, ConicityUnderLoadNearTheCentreIsThatOfElasticBodies) {
  // Change of radius per shift: 0.166 and 0.160 on half-spaces over +-0.5 and +-3 mm; of rigid
  // bodies 0.56 over +-0.5 mm.
  const WheelRail pair = Create(CapeGauge());
  for (const auto& [y, tolerance] : {std::pair{0.5e-3, 0.08}, {3e-3, 0.03}}) {
    const double reference =
        (ByHalfSpace(CapeGauge(), y).radius - ByHalfSpace(CapeGauge(), -y).radius) / (2 * y);
    const double own = (Own(pair, y).radius - Own(pair, -y).radius) / (2 * y);
    EXPECT_NEAR(own / reference, 1, tolerance) << "y = " << y;
  }
}

TEST(HalfSpaceTest, EquivalentConicityUnderLoadIsThatOfElasticBodies) {
  // Rigid bodies 0.37 at 1 mm, as they jump; elastic ones as in wide swings.
  const WheelRail pair = Create(CapeGauge());
  const auto rigid = CalcContactFunctions(pair, pair, 4e-3, 0.1e-3);
  const auto loaded = CalcContactFunctions(pair, pair, 4e-3, 0.5e-3, kAxleLoad);
  ASSERT_TRUE(rigid.ok() && loaded.ok());
  EXPECT_GT(rigid.value().conicity[0].value, 0.3);
  const double reference =
      (ByHalfSpace(CapeGauge(), 1e-3).radius - ByHalfSpace(CapeGauge(), -1e-3).radius) / 2e-3;
  EXPECT_NEAR(loaded.value().conicity[0].value / reference, 1, 0.1);
}

}  // namespace
}  // namespace phs::rail
