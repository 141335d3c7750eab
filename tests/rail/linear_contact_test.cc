#include "rail/linear_contact.h"

#include <gtest/gtest.h>

namespace phs::rail {
namespace {

// N = N0 + k d + c d', d = z + a roll + r0; the wheel feels k d + c d' upwards, N0 is the weight's.
TEST(LinearContact, LoadFollowsDepthAndItsRate) {
  LinearContactParams p;
  p.half_base_m = 0.75;
  p.load_N = 60e3;
  p.stiffness_N_per_m = 1e9;
  p.damping_Ns_per_m = 2e5;
  WheelsetMotion motion;
  motion.speed = 20;
  motion.velocity = {20, 0, 0.03};
  motion.vertical = -0.46 + 12e-6;
  motion.roll = 8e-6;
  WheelRailForces forces;
  CalcLinearContact(p, 0.46, 0.1, motion, &forces);
  const double elastic = 1e9 * (12e-6 + 0.75 * 8e-6), damper = 2e5 * 0.03;
  EXPECT_NEAR(forces.patch[0].normal, 60e3 + elastic + damper, 1e-3);
  EXPECT_NEAR(forces.force[2], -elastic - damper, 1e-3);
  EXPECT_NEAR(forces.elastic_force[2], -elastic, 1e-3);
  EXPECT_NEAR(forces.damping_power, damper * 0.03, 1e-9);
  EXPECT_NEAR(forces.stored_energy, 0.5 * elastic * elastic / 1e9, 1e-9);
}

// Beyond the clearance the flange pushes inwards.
TEST(LinearContact, TheFlangeIsASpringBehindItsClearance) {
  LinearContactParams p;
  p.flange_N_per_m = 14.6e6;
  p.clearance_m = 6e-3;
  WheelsetMotion motion;
  motion.speed = 20;
  motion.velocity = {20, 0, 0};
  motion.vertical = -0.46;
  WheelRailForces forces;
  for (const double y : {-8e-3, 5e-3, 7e-3}) {
    motion.lateral = y;
    CalcLinearContact(p, 0.46, 0.1, motion, &forces);
    const double beyond = y > 6e-3 ? y - 6e-3 : 0;
    EXPECT_NEAR(forces.elastic_force[1], -14.6e6 * beyond, 1e-6);
    EXPECT_NEAR(forces.stored_energy, 0.5 * 14.6e6 * beyond * beyond, 1e-9);
  }
}

}  // namespace
}  // namespace phs::rail
