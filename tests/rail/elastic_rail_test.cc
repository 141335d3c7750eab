// Rails on springs: balance of spring and contact, one energy of both.
#include "rail/elastic_rail.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact_pair.h"

namespace phs::rail {
namespace {

TEST(ElasticRail, SupportIsInSeriesWithTheContact) {
  const WheelRail pair = Create(StandardPair());
  for (const RailSupport& support :
       {RailSupport{0, 0, 6e7, 0}, RailSupport{2e7, 0, 4e7, 0}, RailSupport{5e6, 0, 1e9, 0}}) {
    for (const double y : {-5e-3, 0.0, 5e-3, 6.5e-3}) {
      WheelsetMotion m = Rolling(pair, 20, y, 0, 3e-3);
      const WheelRailForces f = Load(pair, 8e4, &m, support);
      ASSERT_GT(f.count, 0);
      // Rigid rail displaced by hand: the same forces.
      const RailOffset moved{-f.rail_lateral, -f.rail_vertical, 0, 0};
      const WheelRailForces rigid = Calc(pair, m, {}, moved);
      EXPECT_NEAR(-rigid.force[2], 8e4, 16);
      EXPECT_NEAR(f.rail_vertical * support.vertical_stiffness_N_per_m, -f.elastic_force[2], 16);
      if (support.lateral_stiffness_N_per_m > 0) {
        EXPECT_NEAR(f.rail_lateral * support.lateral_stiffness_N_per_m, -f.elastic_force[1], 16);
      } else {
        EXPECT_EQ(f.rail_lateral, 0);
      }
    }
  }
}

/// Calls `check(pair, support, motion, forces)` at random poses that carry 80 kN.
template <typename Check>
void AtRandomPoses(unsigned seed, const Check& check) {
  const WheelRail pair = Create(StandardPair());
  const RailSupport support{2e7, 0, 6e7, 0};
  std::mt19937 random(seed);
  std::uniform_real_distribution<> unit(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    const double lateral = 6.5e-3 * unit(random), roll = 0.5e-3 * unit(random);
    WheelsetMotion m = Rolling(pair, 20, lateral, roll, 3e-3 * unit(random));
    const WheelRailForces f = Load(pair, 8e4, &m, support);
    check(pair, support, m, f);
  }
}

TEST(ElasticRail, StandsWhereSpringsBalanceTheContact) {
  AtRandomPoses(3, [](const WheelRail&, const RailSupport& s, const WheelsetMotion&,
                      const WheelRailForces& f) {
    EXPECT_NEAR(f.rail_vertical * s.vertical_stiffness_N_per_m, -f.elastic_force[2], 4e-4 * 8e4);
    EXPECT_NEAR(f.rail_lateral * s.lateral_stiffness_N_per_m, -f.elastic_force[1], 4e-4 * 8e4);
  });
}

TEST(ElasticRail, ForceIsTheSlopeOfWhatContactAndSpringsStore) {
  constexpr double kStep = 0.2e-6;
  AtRandomPoses(4, [](const WheelRail& pair, const RailSupport& support, const WheelsetMotion& m,
                      const WheelRailForces& f) {
    const auto slope = [&](double WheelsetMotion::*place) {
      WheelsetMotion less = m, more = m;
      less.*place -= kStep;
      more.*place += kStep;
      return (Calc(pair, more, support).stored_energy - Calc(pair, less, support).stored_energy) /
             (2 * kStep);
    };
    EXPECT_NEAR(f.elastic_force[1], -slope(&WheelsetMotion::lateral), 5e-4 * 8e4);
    EXPECT_NEAR(f.elastic_force[2], -slope(&WheelsetMotion::vertical), 5e-4 * 8e4);
  });
}

TEST(ElasticRail, TheDamperOfTheSupportTakesPower) {
  WheelRailParams params = StandardPair();
  params.damping_ratio = 0;
  const WheelRail pair = Create(params);
  WheelsetMotion m = Rolling(pair, 20, 0, 0, 0);
  m.vertical = pair.touching_height() + 2e-3;
  m.velocity[2] = 0.02;  // downwards
  const RailSupport springs{3e7, 0, 7e7, 0};
  RailSupport dampers = springs;
  dampers.vertical_damping_Ns_per_m = 9e4;
  const WheelRailForces without = Calc(pair, m, springs, {}, Side::kRight);
  const WheelRailForces with = Calc(pair, m, dampers, {}, Side::kRight);
  EXPECT_NEAR(without.damping_power, 0, 1e-9);
  // The rail gives way by nearly all of the motion: c v^2, a little less.
  EXPECT_NEAR(with.damping_power, 9e4 * 0.02 * 0.02, 0.2 * 36);
  EXPECT_NEAR(with.force[2] - without.force[2], -9e4 * 0.02, 0.1 * 1800);
}

}  // namespace
}  // namespace phs::rail
