// Traction and braking at a held speed.
#include "plugin/running_forces.h"

#include <gmock/gmock.h>

#include <cmath>

#include "vehicle/scenario.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

Scenario Running(const std::string& bogie, double torque, double blocks) {
  Scenario s;
  s.name = "running";
  s.bogie = bogie;
  s.track = "straight";
  s.speed_m_s = 15;
  s.friction.tread = 0.4;
  s.duration_s = 6;
  s.running.active = true;
  s.running.drive_torque_Nm = torque;
  s.running.block_force_N = blocks;
  s.running.begin_s = 0.5;
  s.running.ramp_s = 1;
  return s;
}

struct Finished {
  RunOutcome run;
  double Last(const std::string& channel) const {
    return run.columns[static_cast<size_t>(run.Find(channel))].back();
  }
};

Finished RunToEnd(const Scenario& scenario) {
  auto sim = Simulation::Create(scenario);
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run();
  EXPECT_EQ(run.value().status, "ok") << run.value().reason;
  return {std::move(run).value()};
}

TEST(RunningForcesTest, TheRailsGiveTheTorqueOfTheDrivesOverTheRadius) {
  for (const double torque : {20e3, -20e3}) {
    const Finished f = RunToEnd(Running("phs", torque, 0));
    for (const char* axle : {"lead", "trail"}) {
      // The tape circle rolls on UIC60 at 0.625 m within a few tenths of a millimetre.
      EXPECT_NEAR(f.Last(std::string(axle) + "_X_N") / (torque / 0.625), 1, 5e-3) << axle;
      EXPECT_GT(f.Last(std::string(axle) + "_slip") * torque, 0);
    }
    EXPECT_NEAR(f.Last("speed_m_s"), 15, 0.02);
    EXPECT_LT(std::abs(f.run.energy.RelativeError()), 2e-3);
  }
}

// Against what goes through drives and coupler, 27 MJ, a power left out of the book is nothing; so
// against what the wheels lose: the coupler beside the centre of a body that turns with the track moves
// otherwise than that centre, which was 1.5 % of it.
TEST(RunningForcesTest, TheBookOfATrainThatPullsInACurveCloses) {
  Scenario s = Running("phs", 20e3, 0);
  s.track = "curve_r300";
  s.speed_m_s = 11;
  s.duration_s = 20;
  const Finished f = RunToEnd(s);
  EXPECT_GT(f.run.energy.lost_creep, 1.5e4);
  EXPECT_LT(std::abs(f.run.energy.Error()), 1e-3 * f.run.energy.lost_creep);
}

TEST(RunningForcesTest, TractionGoesAsItCame) {
  const plugin::RunningForces r{.active = true, .begin_s = 1, .ramp_s = 2, .end_s = 4};
  const double share[] = {0, 0, 0.5, 1, 1, 0.5, 0, 0};
  for (int i = 0; i < 8; ++i) EXPECT_DOUBLE_EQ(r.Share(i), share[i]) << i << " s";
  Scenario s = Running("phs", 20e3, 0);
  s.running.end_s = 2;
  const Finished f = RunToEnd(s);
  EXPECT_NEAR(f.Last("lead_X_N") / (20e3 / 0.625), 0, 5e-3);
  EXPECT_NEAR(f.Last("speed_m_s"), 15, 0.02);
}

TEST(RunningForcesTest, BrakeBlocksTakeTheirFrictionFromTheRails) {
  const Finished f = RunToEnd(Running("rigid_link", 0, 30e3));
  const double per_axle = 2 * 0.25 * 30e3;
  EXPECT_NEAR(f.Last("lead_X_N") / -per_axle, 1, 5e-3);
  EXPECT_NEAR(f.Last("trail_X_N") / -per_axle, 1, 5e-3);
  EXPECT_NEAR(f.Last("speed_m_s"), 15, 0.02);
  // 15 kN per axle over the 5 s after the ramp's middle at 15 m/s.
  EXPECT_NEAR(f.run.energy.lost_brakes / (2 * per_axle * 15 * 5), 1, 0.01);
  EXPECT_LT(std::abs(f.run.energy.RelativeError()), 2e-3);
}

TEST(RunningForcesTest, AdhesionInUseIsTheTractiveShareOfTheFriction) {
  const Finished f = RunToEnd(Running("phs", 0.25 * 26000 * 9.81 * 0.625, 0));
  double mean = 0;
  for (const char* wheel : {"lead_left", "lead_right", "trail_left", "trail_right"}) {
    mean += f.Last(std::string(wheel) + "_adhesion_used") / 4;
  }
  EXPECT_NEAR(mean, 0.25 / 0.4, 0.01);
}

TEST(RunningForcesTest, ALocomotiveIsPulledAtItsDrawgear) {
  Scenario s = Running("phs", 10e3, 0);
  s.vehicle = "locomotive";
  s.duration_s = 4;
  const Finished f = RunToEnd(s);
  double pull = 0;
  for (const char* axle : {"front_lead", "front_trail", "rear_lead", "rear_trail"}) {
    pull += f.Last(std::string(axle) + "_X_N");
  }
  EXPECT_NEAR(pull / (4 * 10e3 / 0.625), 1, 0.01);
  // The drawgear, 0.9 m above the rails, takes load off the front axle.
  EXPECT_LT(f.Last("front_lead_left_Q_N"), f.Last("rear_trail_left_Q_N"));
}

TEST(RunningForcesTest, TheShareRisesFromZeroToOne) {
  const plugin::RunningForces r{.active = true, .begin_s = 2, .ramp_s = 4};
  EXPECT_EQ(r.Share(0), 0);
  EXPECT_DOUBLE_EQ(r.Share(4), 0.5);
  EXPECT_EQ(r.Share(7), 1);
}

}  // namespace
}  // namespace phs::vehicle
