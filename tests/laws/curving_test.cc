// Laws of the whole curving run, on the product's own vehicle and curve.
#include <gtest/gtest.h>

#include <cmath>

#include "plugin/settle.h"
#include "tests/base/scratch_dir.h"
#include "tests/laws/law_models.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;

Scenario Curve(const std::string& bogie, const std::string& track, double speed) {
  Scenario s;
  s.name = "law";
  s.track = track;
  s.bogie = bogie;
  s.wheel = "S1002";
  s.rail = "UIC60";
  s.creep = "kalker_table";
  s.speed_m_s = speed;
  s.friction.tread = 0.3;
  return s;
}

struct Finished {
  Json summary;
  RunOutcome run;
};

Finished RunToEnd(const Scenario& scenario) {
  auto simulation = Simulation::Create(scenario);
  EXPECT_TRUE(simulation.ok()) << simulation.error().Line();
  if (!simulation.ok()) return {};
  auto run = simulation.value().Run();
  EXPECT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "ok") << run.value().reason;
  return {SummaryJson(Summarise(simulation.value(), run.value())), run.value()};
}

double Wheelset(const Finished& f, int index, const char* key) {
  return f.summary["steady_curve"]["wheelsets"][index][key].get<double>();
}
double Wheel(const Finished& f, const std::string& name, const char* key) {
  for (const Json& wheel : f.summary["steady_curve"]["wheels"]) {
    if (wheel["name"] == name) return wheel[key].get<double>();
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST(CurvingTest, EnergyOfAFullRunBalancesWithinATenthOfAPercent) {
  for (const char* bogie : {"phs", "rigid_link"}) {
    const Finished f = RunToEnd(Curve(bogie, "curve_r550", 80 / 3.6));
    EXPECT_LT(std::abs(f.run.energy.RelativeError()), 1e-3) << bogie;
    EXPECT_GT(f.run.energy.work_in, 1000) << bogie;
    EXPECT_GT(f.run.energy.lost_creep, 1000) << bogie;
  }
}

TEST(CurvingTest, RightHandCurveMirrorsTheLeftToRounding) {
  const ScratchDir folder;
  const auto track = [&](const char* hand) {
    return folder.Write(std::string(hand) + ".yaml", laws::CurvedTrack(400, 15, hand));
  };
  const Finished left = RunToEnd(Curve("phs", track("left"), 15));
  const Finished right = RunToEnd(Curve("phs", track("right"), 15));
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(Wheelset(left, i, "lateral_m"), -Wheelset(right, i, "lateral_m"), 1e-9);
    EXPECT_NEAR(Wheelset(left, i, "angle_of_attack_rad"),
                -Wheelset(right, i, "angle_of_attack_rad"), 1e-9);
  }
  for (const char* wheel : {"lead_outer", "lead_inner", "trail_outer", "trail_inner"}) {
    EXPECT_NEAR(Wheel(left, wheel, "Y_N"), Wheel(right, wheel, "Y_N"), 1e-2) << wheel;
    EXPECT_NEAR(Wheel(left, wheel, "Q_N"), Wheel(right, wheel, "Q_N"), 1e-2) << wheel;
  }
}

TEST(CurvingTest, HalvingTheStepChangesTheSteadyCurveByLessThanHalfAPercent) {
  Scenario coarse = Curve("phs", "curve_r400", 15);
  coarse.timestep_s = kDefaultStep_s;
  Scenario fine = coarse;
  fine.timestep_s = coarse.timestep_s / 2;
  const Finished a = RunToEnd(coarse);
  const Finished b = RunToEnd(fine);
  // The steered axle's angle is near zero: its change is taken against a/R of the curve.
  EXPECT_NEAR(Wheelset(a, 0, "angle_of_attack_rad"), Wheelset(b, 0, "angle_of_attack_rad"),
              5e-3 * 1.55 / 400);
  EXPECT_NEAR(Wheelset(a, 0, "lateral_m") / Wheelset(b, 0, "lateral_m"), 1, 5e-3);
  EXPECT_NEAR(Wheel(a, "lead_outer", "Q_N") / Wheel(b, "lead_outer", "Q_N"), 1, 5e-3);
  EXPECT_NEAR(Wheel(a, "lead_outer", "Y_N") / Wheel(b, "lead_outer", "Y_N"), 1, 5e-3);
}

TEST(CurvingTest, LoadTransferAtCantDeficiencyFollowsStatics) {
  // Quasi-static: in the canted plane every mass m pulls outwards with its unbalanced acceleration
  // v^2 k cos(cant) - g sin(cant) and presses down with g cos(cant) + v^2 k sin(cant). The moment
  // of the wheel-rail forces about the track centre must balance them.
  Scenario s = Curve("rigid_link", "curve_r550", 80 / 3.6);
  auto simulation = Simulation::Create(s);
  ASSERT_TRUE(simulation.ok());
  const mjModel* m = simulation.value().model();
  mjData* d = simulation.value().data();
  plugin::ResetToStart(m, d);
  const plugin::Binding& binding = simulation.value().binding();
  while (binding.CalcWheelset(m, d, 0).frame.s < 400) mj_step(m, d);
  mj_forward(m, d);
  double roll_moment = 0;  // of the wheel-rail forces about the rail-top centre line, T axes
  double lateral = 0;
  double transfer = 0;
  rail::TrackFrame frame;
  double speed = 0;
  for (int i = 0; i < 2; ++i) {
    const plugin::WheelsetState w = binding.CalcWheelset(m, d, i);
    frame = w.frame;
    speed = w.speed;
    double fy = 0;
    double fz = 0;
    for (int k = 0; k < 3; ++k) {
      fy += w.frame.left[k] * w.force[k];
      fz += w.frame.up[k] * w.force[k];
    }
    roll_moment += w.moment_T[0] + w.lateral * fz - w.vertical * fy;
    lateral += fy;
    transfer += w.wheel[0].force[2] - w.wheel[1].force[2];
  }
  const double kv2 = frame.curvature * speed * speed;
  const double inward = kv2 * std::cos(frame.cant) - 9.81 * std::sin(frame.cant);
  const double down = 9.81 * std::cos(frame.cant) + kv2 * std::sin(frame.cant);
  double expected = 0;
  for (int b = 1; b < m->nbody; ++b) {
    // Each body in the track plane at its own place along the curve.
    const rail::Vec3 centre = {d->xipos[3 * b], d->xipos[3 * b + 1], d->xipos[3 * b + 2]};
    const rail::TrackFrame f = binding.track().FrameAt(binding.track().Project(centre));
    double y = 0;
    double z = 0;
    for (int k = 0; k < 3; ++k) {
      y += f.left[k] * (centre[k] - f.origin[k]);
      z += f.up[k] * (centre[k] - f.origin[k]);
    }
    expected += m->body_mass[b] * (down * y - inward * z);
  }
  // The spin of each wheelset (300 kg m^2, about +y) turns left with the curve: dL/dt is along -x.
  expected -= 2 * 300 * (speed / 0.625) * frame.curvature * speed;
  EXPECT_NEAR(roll_moment / expected, 1, 0.03);
  EXPECT_NEAR(lateral / (52000 * inward), 1, 0.01);
  EXPECT_GT(transfer, 2 * 26000 * inward);  // and the outer wheels do carry more
}

TEST(CurvingTest, TheSameInputsGiveTheSameBits) {
  Scenario s = Curve("phs", "curve_r250", 12);
  s.duration_s = 4;
  const Finished a = RunToEnd(s);
  const Finished b = RunToEnd(s);
  EXPECT_EQ(a.run.columns, b.run.columns);
}

TEST(CurvingTest, AWildSpeedDerailsWithAReason) {
  auto simulation = Simulation::Create(Curve("rigid_link", "curve_r150", 45));
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  auto run = simulation.value().Run();
  ASSERT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "derailed");
  EXPECT_NE(run.value().reason, "");
}

TEST(CurvingTest, AStepTooLargeIsRefusedWithTheLargestStableOne) {
  Scenario s = Curve("rigid_link", "straight", 20);
  s.timestep_s = 0.03;
  const auto simulation = Simulation::Create(s);
  ASSERT_FALSE(simulation.ok());
  EXPECT_NE(simulation.error().Line().find("timestep_s"), std::string::npos);
}

TEST(CurvingTest, TheLocomotiveRunsTheSameCurve) {
  Scenario s = Curve("phs", "curve_r550", 80 / 3.6);
  s.vehicle = "locomotive";
  const Finished f = RunToEnd(s);
  double load = 0;
  for (const Json& wheel : f.summary["steady_curve"]["wheels"]) load += wheel["Q_N"].get<double>();
  EXPECT_EQ(f.summary["steady_curve"]["wheels"].size(), 8u);
  EXPECT_NEAR(load / (104000 * 9.81), 1, 0.02);
  EXPECT_EQ(f.summary["steady_curve"]["cylinders"].size(), 8u);
}

}  // namespace
}  // namespace phs::vehicle
