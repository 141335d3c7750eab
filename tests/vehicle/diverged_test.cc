// A step far too large: MuJoCo 2.2.2 resets the state and goes on; the program says so.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "vehicle/simulation.h"
#include "vehicle/stable_step.h"

namespace phs::vehicle {
namespace {

Scenario Diverging() {
  Scenario s;
  s.name = "diverged";
  s.track = "straight";
  s.speed_m_s = 20;
  s.friction.tread = 0.35;
  s.duration_s = 5;
  return s;
}

TEST(DivergedTest, AStepThatMuJoCoCannotFollowIsNotTakenForStable) {
  for (const double step : {0.01, 0.1, 1.0, 10.0}) {
    Scenario s = Diverging();
    s.timestep_s = step;
    auto sim = Simulation::Create(s);
    ASSERT_FALSE(sim.ok()) << step;
    EXPECT_NE(sim.error().Line().find("timestep_s"), std::string::npos) << sim.error().Line();
  }
}

TEST(DivergedTest, ASilentResetEndsTheRun) {
  auto sim = Simulation::Create(Diverging());
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run([&](double) {
    sim.value().data()->qvel[2] = 1e11;  // more than MuJoCo goes on with
    return true;
  });
  ASSERT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "diverged");
  EXPECT_NE(run.value().reason.find("t = "), std::string::npos) << run.value().reason;
  EXPECT_LT(run.value().steps, 10);
}

TEST(DivergedTest, AStepFarTooLargeDoesNotEndWell) {
  auto sim = Simulation::Create(Diverging());
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  sim.value().mutable_model()->opt.timestep = 0.05;
  EXPECT_NE(sim.value().Run().value().status, "ok");
}

}  // namespace
}  // namespace phs::vehicle
