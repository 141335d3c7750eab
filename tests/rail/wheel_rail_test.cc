#include "rail/wheel_rail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "contact_pair.h"
#include "rail/hertz.h"

namespace phs::rail {
namespace {

TEST(WheelRail, StaticLoadOfAConeOnAnArcIsHertz) {
  const WheelRail pair = Create(ConeOnArc("0.05", "0.3"));
  WheelsetMotion m = Rolling(pair, 0, 0, 0, 0);
  const double sunk = 8e-5;
  m.vertical += sunk;
  const WheelRailForces f = Calc(pair, m);
  ASSERT_EQ(f.count, 1);
  const double cosine = 1 / std::sqrt(1 + 0.05 * 0.05);
  const ContactPatch& p = f.patch[0];
  const HertzContact h =
      Hertz(82e9, 0.28).AtApproach(sunk * cosine, 0.5 * cosine / p.rolling_radius, 0.5 / 0.3);
  EXPECT_NEAR(p.normal / h.normal, 1, 2e-3);
  EXPECT_NEAR(p.a / h.a, 1, 2e-3);
  EXPECT_NEAR(p.b / h.b, 1, 2e-3);
  EXPECT_NEAR(-f.force[2] / (h.normal * cosine), 1, 2e-3);
  EXPECT_NEAR(p.angle, std::atan(0.05), 1e-5);
}

TEST(WheelRail, ForceIsTheSlopeOfTheStoredEnergyForAParabolicGap) {
  const WheelRail pair = Create(ConeOnArc("0.025", "0.3"));
  WheelsetMotion m = Rolling(pair, 0, 0, 0, 0);
  for (const double sunk : {2e-6, 2e-5, 1e-4}) {
    m.vertical = pair.touching_height() + sunk;
    const double force = -Calc(pair, m).force[2];
    const double h = 1e-3 * sunk;
    m.vertical += h;
    const double up = Calc(pair, m).stored_energy;
    m.vertical -= 2 * h;
    const double down = Calc(pair, m).stored_energy;
    EXPECT_NEAR((up - down) / (2 * h) / force, 1, 2e-3) << sunk;
  }
}

TEST(WheelRail, ForceIsNearTheSlopeOfTheStoredEnergyForRealProfiles) {
  const WheelRail pair = Create(StandardPair());
  double worst = 0, sum = 0;
  int count = 0;
  for (double y = -8e-3; y < 8e-3; y += 0.1e-3) {
    WheelsetMotion m = Rolling(pair, 0, y, 0, 2e-3);
    const double force = -Load(pair, 1e5, &m).force[2];
    m.vertical += 1e-7;
    const double up = Calc(pair, m).stored_energy;
    m.vertical -= 2e-7;
    const double down = Calc(pair, m).stored_energy;
    const double error = std::abs((up - down) / 2e-7 / force - 1);
    worst = std::max(worst, error);
    sum += error;
    ++count;
  }
  EXPECT_LT(sum / count, 2e-3);
  EXPECT_LT(worst, 0.05);  // also where two patches grow into one
}

/// States anywhere between the flanges, with every velocity.
WheelsetMotion RandomState(const WheelRail& pair, std::mt19937* random) {
  const auto pick = [&](double size) {
    return std::uniform_real_distribution<double>(-size, size)(*random);
  };
  WheelsetMotion m = Rolling(pair, 20 + pick(19), pick(8e-3), pick(5e-3), pick(20e-3));
  m.vertical += 1e-4 + pick(3e-4);
  for (size_t i = 0; i < 3; ++i) {
    m.velocity[i] += pick(0.1);
    m.rotation[i] += pick(0.2);
  }
  return m;
}

TEST(WheelRail, PowerOfTheWrenchIsElasticPowerPlusLossesToRounding) {
  WheelRailParams params = StandardPair();
  params.damping_ratio = 0.2;
  const WheelRail pair = Create(params);
  std::mt19937 random(1);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const WheelsetMotion m = RandomState(pair, &random);
    RailOffset rail;
    rail.lateral_slope = 1e-3;
    rail.vertical_slope = -2e-3;
    const WheelRailForces f = Calc(pair, m, {}, rail);
    const double wrench = Dot(f.force, m.velocity) + Dot(f.moment, m.rotation);
    const double elastic = Dot(f.elastic_force, m.velocity) + Dot(f.elastic_moment, m.rotation);
    const double size = std::abs(elastic) + f.creep_power + f.damping_power + 1;
    EXPECT_NEAR(wrench - elastic, -f.creep_power - f.damping_power, 1e-9 * size);
    EXPECT_GE(f.creep_power, -1e-9 * size);
    EXPECT_GE(f.damping_power, -1e-9 * size);
    touching += f.count > 0;
  }
  EXPECT_GT(touching, 800);
}

TEST(WheelRail, NormalForceDoesNoWorkOnTheSpin) {
  const WheelRail pair = Create(StandardPair());
  std::mt19937 random(2);
  for (int i = 0; i < 500; ++i) {
    const WheelsetMotion m = RandomState(pair, &random);
    RailOffset rail;
    rail.vertical_slope = 3e-3;
    const WheelRailForces f = Calc(pair, m, {}, rail);
    const Vec3 axle = {-std::sin(m.yaw) * std::cos(m.roll), std::cos(m.yaw) * std::cos(m.roll),
                       std::sin(m.roll)};
    // The slope of the rail is taken to first order.
    EXPECT_NEAR(Dot(f.elastic_moment, axle), 0, 4e-5 * (1 + std::abs(f.elastic_force[2])));
    const WheelRailForces level = Calc(pair, m);
    EXPECT_NEAR(Dot(level.elastic_moment, axle), 0, 1e-11 * (1 + std::abs(f.elastic_force[2])));
  }
}

TEST(WheelRail, NormalForceNeverPulls) {
  WheelRailParams params = StandardPair();
  params.damping_ratio = 1;
  const WheelRail pair = Create(params);
  WheelsetMotion m = Rolling(pair, 20, 0, 0, 0);
  m.vertical += 1e-4;
  for (const double speed : {-10.0, -0.5, -0.01}) {
    m.velocity[2] = speed;
    const WheelRailForces f = Calc(pair, m);
    for (int k = 0; k < f.count; ++k) EXPECT_GE(f.patch[static_cast<size_t>(k)].normal, 0);
    EXPECT_GE(f.damping_power, 0);
  }
  m.velocity[2] = 0.01;
  const double in = Calc(pair, m).patch[0].normal;
  m.velocity[2] = 0;
  EXPECT_GT(in, Calc(pair, m).patch[0].normal);
}

TEST(WheelRail, LeftIsTheMirrorImageOfRightToTheLastBit) {
  const WheelRail pair = Create(StandardPair());
  const RailSupport support{3e7, 1e4, 7e7, 2e4};
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    const WheelsetMotion m = RandomState(pair, &random);
    // T axes: the left rail of a mirrored track has the opposite lateral displacement.
    const RailOffset left{1.3e-3, -0.4e-3, 1e-3, 2e-3};
    const RailOffset right{-1.3e-3, -0.4e-3, -1e-3, 2e-3};
    const WheelRailForces a = Calc(pair, m, support, left, Side::kLeft);
    const WheelRailForces b = Calc(pair, m, support, right, Side::kRight);
    ASSERT_EQ(a.count, b.count);
    EXPECT_EQ(a.force, b.force);
    EXPECT_EQ(a.moment, b.moment);
  }
}

// Rigid bodies, upright: the deepest place of the one profile laid over the other, looked for at every
// hundredth of a millimetre.
TEST(WheelRail, RigidBodiesTouchWhereTheProfilesAreNearest) {
  const WheelRailParams p = StandardPair();
  const WheelRail pair = Create(p);
  const Profile& wheel = *pair.wheel_profile();
  const Profile& rail = *pair.rail_profile();
  for (double y = -8e-3; y < 6.2e-3; y += 0.25e-3) {
    const double shift = pair.wheel_position() + y - pair.rail_position();
    double most = -1;
    double at = 0;
    for (double w = wheel.min_y(); w < wheel.max_y(); w += 1e-5) {
      if (w + shift < rail.min_y() || w + shift > rail.max_y()) continue;
      const double depth = wheel.At(w).z - rail.At(w + shift).z;
      if (depth <= most) continue;
      most = depth;
      at = w;
    }
    const TouchPoint touch = pair.Touch(y, 0, 0);
    ASSERT_TRUE(touch.found) << y;
    EXPECT_NEAR(touch.wheel_y, at, 0.05e-3) << y;
    EXPECT_NEAR(touch.radius, p.wheel_radius + wheel.At(at).z, 0.02e-3) << y;
  }
}

TEST(WheelRail, LiftedWheelHasNoForce) {
  const WheelRail pair = Create(StandardPair());
  WheelsetMotion m = Rolling(pair, 20, 0, 0, 0);
  m.vertical -= 1e-3;
  const WheelRailForces f = Calc(pair, m, {3e7, 0, 7e7, 0});
  EXPECT_EQ(f.count, 0);
  EXPECT_EQ(f.force, (Vec3{}));
  EXPECT_EQ(f.stored_energy, 0);
  m.vertical = std::nan("");
  EXPECT_EQ(Calc(pair, m).count, 0);
}

TEST(WheelRail, ResultsOfAnEarlierCallDoNotStay) {
  const WheelRail pair = Create(StandardPair());
  WheelsetMotion m = Rolling(pair, 20, 5e-3, 0, 5e-3);
  WheelRailForces used;
  m.vertical += 3e-4;
  pair.Calc(m, Side::kRight, {}, {1e7, 0, 1e7, 0}, &used);
  m = Rolling(pair, 20, -2e-3, 0, 0);
  m.vertical += 1e-4;
  pair.Calc(m, Side::kRight, {}, {}, &used);
  const WheelRailForces fresh = Calc(pair, m);
  EXPECT_EQ(used.force, fresh.force);
  EXPECT_EQ(used.stored_energy, fresh.stored_energy);
  EXPECT_EQ(used.rail_lateral, 0);
  ASSERT_EQ(used.count, fresh.count);
  EXPECT_EQ(used.patch[0].weight, fresh.patch[0].weight);
}

TEST(WheelRail, ClimbingFlangeIsBeyondTheProfile) {
  const WheelRail pair = Create(StandardPair());
  EXPECT_NEAR(pair.flange_angle(), 70 * 3.14159265 / 180, 0.01);
  WheelsetMotion m = Rolling(pair, 20, 6e-3, 0, 0);
  EXPECT_FALSE(Load(pair, 6e4, &m).beyond_profile);
  m = Rolling(pair, 20, 20e-3, 0, 0);
  EXPECT_TRUE(Load(pair, 6e4, &m).beyond_profile);
  // Nor does a wheel carry at the outer end of its tread.
  m = Rolling(pair, 20, -40e-3, 0, 0);
  EXPECT_FALSE(Load(pair, 6e4, &m).beyond_profile);
  m = Rolling(pair, 20, -80e-3, 0, 0);
  EXPECT_TRUE(Load(pair, 6e4, &m).beyond_profile);
  // A wheel without a flange only falls off at its end.
  const WheelRail cone = Create(ConeOnArc("0.05", "0.3"));
  m = Rolling(cone, 20, 6e-3, 0, 0);
  EXPECT_FALSE(Load(cone, 6e4, &m).beyond_profile);
}

TEST(WheelRail, FlangeFrictionTakesOverWithTheContactAngle) {
  WheelRailParams params = StandardPair();
  params.tread.coefficient = 0.4;
  params.flange.coefficient = 0.1;
  const WheelRail pair = Create(params);
  WheelsetMotion m = Rolling(pair, 20, 0, 0, 0);
  EXPECT_DOUBLE_EQ(Load(pair, 6e4, &m).patch[0].friction, 0.4);
  m = Rolling(pair, 20, 9e-3, 0, 0);
  EXPECT_DOUBLE_EQ(Load(pair, 6e4, &m).patch[0].friction, 0.1);
}

TEST(WheelRail, RunningBackwardsTurnsTheForces) {
  const WheelRail pair = Create(StandardPair());
  WheelsetMotion m = Rolling(pair, 20, 1e-3, 0, 0);
  m.rotation[1] *= 1.002;  // driving
  const WheelRailForces ahead = Load(pair, 6e4, &m);
  m.velocity[0] = -m.velocity[0];
  for (double& w : m.rotation) w = -w;
  const WheelRailForces back = Calc(pair, m);
  EXPECT_GT(ahead.force[0], 1000);
  EXPECT_DOUBLE_EQ(back.force[0], -ahead.force[0]);
  EXPECT_DOUBLE_EQ(back.force[1], ahead.force[1]);  // camber thrust has no direction of running
}

TEST(WheelRail, CreepagesStayFiniteAtStandstill) {
  const WheelRail pair = Create(StandardPair());
  WheelsetMotion m = Rolling(pair, 0, 1e-3, 0, 0);
  m.velocity[1] = 1e-4;
  const WheelRailForces f = Load(pair, 6e4, &m);
  EXPECT_NEAR(f.patch[0].eta, -1e-4 / 0.5, 1e-6);
  EXPECT_LT(f.force[1], 0);
}

TEST(WheelRail, ReferenceSpeedIsTheMeanOfBothBodies) {
  const WheelRail pair = Create(StandardPair());
  WheelsetMotion m = Rolling(pair, 20, 0, 0, 0);
  m.rotation = {};  // locked wheel
  EXPECT_NEAR(Load(pair, 6e4, &m).patch[0].xi, -2, 1e-9);
}

struct BadParams {
  const char* key;
  void (*spoil)(WheelRailParams*);
};
void PrintTo(const BadParams& p, std::ostream* out) { *out << p.key; }
class WheelRailErrors : public testing::TestWithParam<BadParams> {};
TEST_P(WheelRailErrors, NameTheValue) {
  WheelRailParams p = StandardPair();
  GetParam().spoil(&p);
  const auto pair = WheelRail::Create(p);
  ASSERT_FALSE(pair.ok());
  EXPECT_NE(pair.error().Line().find(GetParam().key), std::string::npos) << pair.error().Line();
}

TEST(WheelRail, FlangeBacksThatDoNotFitTheGaugeAreRefusedWithBothNumbers) {
  for (const auto& [flange_back, gauge] : {std::pair{1.360, 1.067}, {0.992, 1.435}}) {
    WheelRailParams p = StandardPair();
    p.gauge = gauge;
    p.flange_back_distance = flange_back;
    const auto pair = WheelRail::Create(p);
    ASSERT_FALSE(pair.ok());
    const std::string line = pair.error().Line();
    EXPECT_NE(line.find(flange_back > 1.2 ? "1.36 m" : "0.992 m"), std::string::npos) << line;
    EXPECT_NE(line.find(gauge > 1.2 ? "gauge of 1.435 m" : "gauge of 1.067 m"), std::string::npos)
        << line;
  }
}

INSTANTIATE_TEST_SUITE_P(
    EveryMessage, WheelRailErrors,
    testing::Values(
        BadParams{"gauge", [](WheelRailParams* p) { p->gauge = 0; }},
        BadParams{"wheel_radius", [](WheelRailParams* p) { p->wheel_radius = -1; }},
        BadParams{"flange_back", [](WheelRailParams* p) { p->flange_back_distance = 9; }},
        BadParams{"friction", [](WheelRailParams* p) { p->tread.coefficient = -1; }},
        BadParams{"damping", [](WheelRailParams* p) { p->damping_ratio = -1; }},
        BadParams{"no/such", [](WheelRailParams* p) { p->rail_profile = "/no/such.prr"; }},
        BadParams{"never touch", [](WheelRailParams* p) { p->flange_back_position = -0.5; }}));

}  // namespace
}  // namespace phs::rail
