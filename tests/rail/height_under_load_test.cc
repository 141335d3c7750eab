#include "rail/height_under_load.h"

#include <gtest/gtest.h>

#include "contact_pair.h"

namespace phs::rail {
namespace {

WheelUnderLoad Wheel(double load) {
  return {.load = load, .carried = VerticalForce, .near = -0.46, .reach = 0.02};
}

TEST(HeightUnderLoad, TheWheelCarriesItsLoadOnTreadAndFlange) {
  const WheelRail pair = Create(StandardPair());
  for (const double lateral : {-6e-3, 0.0, 3e-3, 6.5e-3}) {
    for (const double load : {1e3, 60e3, 200e3}) {
      WheelsetMotion motion;
      motion.lateral = lateral;
      motion.speed = 20;
      motion.velocity = {20, 0, 0};
      motion.rotation = {0, 20 / 0.46, 0};
      WheelRailForces forces;
      ASSERT_TRUE(FindHeightUnderLoad(pair, Wheel(load), &motion, &forces)) << lateral;
      EXPECT_NEAR(-forces.force[2] / load, 1, 1e-6) << lateral << " " << load;
    }
  }
}

// Hertz: the approach of two bodies grows with the load to the power of two thirds.
TEST(HeightUnderLoad, AConeOnARoundRailSinksAsHertzSays) {
  const WheelRail pair = Create(ConeOnArc("0.05", "0.3"));
  const double rigid = pair.Touch(0, 0, 0).height;
  const auto sink = [&](double load) {
    WheelsetMotion motion;
    WheelUnderLoad wheel = Wheel(load);
    wheel.carried = ElasticVerticalForce;
    WheelRailForces forces;
    EXPECT_TRUE(FindHeightUnderLoad(pair, wheel, &motion, &forces));
    return motion.vertical - rigid;
  };
  EXPECT_NEAR(sink(80e3) / sink(10e3), 4, 0.01);
}

TEST(HeightUnderLoad, NoHeightWithinReachIsSaid) {
  const WheelRail pair = Create(StandardPair());
  WheelsetMotion motion;
  WheelRailForces forces;
  WheelUnderLoad wheel = Wheel(80e3);
  wheel.near = -0.5;
  EXPECT_FALSE(FindHeightUnderLoad(pair, wheel, &motion, &forces));
  wheel = Wheel(80e3);
  motion.lateral = 0.5;
  EXPECT_FALSE(FindHeightUnderLoad(pair, wheel, &motion, &forces));
}

}  // namespace
}  // namespace phs::rail
