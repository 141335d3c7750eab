// Laws of the whole curving run, on the product's own vehicle and curve.
#include <gtest/gtest.h>

#include <cmath>

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
  s.friction = 0.3;
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
  return {Summarise(simulation.value(), run.value()), run.value()};
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
  const laws::TestFolder folder;
  const auto track = [&](const char* hand) {
    return folder.Write(std::string(hand) + ".yaml", laws::CurvedTrack(400, 15, hand));
  };
  const Finished left = RunToEnd(Curve("phs", track("left"), 15));
  const Finished right = RunToEnd(Curve("phs", track("right"), 15));
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(Wheelset(left, i, "lateral_m"), -Wheelset(right, i, "lateral_m"), 1e-9);
    EXPECT_NEAR(Wheelset(left, i, "angle_of_attack_rad"), -Wheelset(right, i, "angle_of_attack_rad"),
                1e-9);
  }
  for (const char* wheel : {"lead_outer", "lead_inner", "trail_outer", "trail_inner"}) {
    EXPECT_NEAR(Wheel(left, wheel, "Y_N"), Wheel(right, wheel, "Y_N"), 1e-2) << wheel;
    EXPECT_NEAR(Wheel(left, wheel, "Q_N"), Wheel(right, wheel, "Q_N"), 1e-2) << wheel;
  }
}

TEST(CurvingTest, HalvingTheStepChangesTheSteadyCurveByLessThanHalfAPercent) {
  Scenario coarse = Curve("phs", "curve_r400", 15);
  Scenario fine = coarse;
  fine.timestep_s = coarse.timestep_s / 2;
  const Finished a = RunToEnd(coarse);
  const Finished b = RunToEnd(fine);
  EXPECT_NEAR(Wheelset(a, 0, "angle_of_attack_rad") / Wheelset(b, 0, "angle_of_attack_rad"), 1, 5e-3);
  EXPECT_NEAR(Wheelset(a, 0, "lateral_m") / Wheelset(b, 0, "lateral_m"), 1, 5e-3);
  EXPECT_NEAR(Wheel(a, "lead_outer", "Q_N") / Wheel(b, "lead_outer", "Q_N"), 1, 5e-3);
  EXPECT_NEAR(Wheel(a, "lead_outer", "Y_N") / Wheel(b, "lead_outer", "Y_N"), 1, 5e-3);
}

TEST(CurvingTest, LoadTransferAtCantDeficiencyFollowsStatics) {
  // Moments about the mid of the track in the canted plane. With body and bogie rigid in roll the
  // transfer per axle is m a_lat h / (2 b0); the secondary roll adds m g y_cg, taken from the run.
  const Finished f = RunToEnd(Curve("rigid_link", "curve_r550", 80 / 3.6));
  const double outer = Wheel(f, "lead_outer", "Q_N") + Wheel(f, "trail_outer", "Q_N");
  const double inner = Wheel(f, "lead_inner", "Q_N") + Wheel(f, "trail_inner", "Q_N");
  auto simulation = Simulation::Create(Curve("rigid_link", "curve_r550", 80 / 3.6));
  ASSERT_TRUE(simulation.ok());
  const rail::Track& track = simulation.value().binding().track();
  const double end = f.summary["steady_curve"]["end_s_m"].get<double>();
  const rail::TrackFrame frame = track.FrameAt(end - 5);
  const double speed = f.summary["steady_curve"]["speed_m_s"].get<double>();
  const double unbalanced = speed * speed * frame.curvature * std::cos(frame.cant) -
                            9.81 * std::sin(frame.cant);
  // Axle by axle: unsprung 2 x 4600 kg at 0.625 m, frame 10000 kg at 0.725 m, body 32800 kg at 2.0 m.
  const double moment = unbalanced * (2 * 4600 * 0.625 + 10000 * 0.725 + 32800 * 2.0);
  const double rigid = moment / 1.137;
  // Roll on the springs shifts the centres of gravity by a few centimetres: a share below 15 %.
  EXPECT_GT((outer - inner) / 2, 1.00 * rigid);
  EXPECT_LT((outer - inner) / 2, 1.20 * rigid);
  // What pushes outwards together is the unbalanced lateral force.
  const double sum_y = Wheelset(f, 0, "sum_Y_N") + Wheelset(f, 1, "sum_Y_N");
  EXPECT_NEAR(std::abs(sum_y) / (52000 * unbalanced), 1, 0.01);
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
