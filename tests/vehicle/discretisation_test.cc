// What a run says of its own step: changes judged as docs/results.md promises.
#include "vehicle/discretisation.h"

#include <gmock/gmock.h>

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;
using testing::Contains;
using testing::Not;

/// A locomotive with one axle per bogie, all numbers `factor` times those of the run.
RunSummary Summary(double timestep, double factor) {
  RunSummary s{"ok", "", "phs", 0, timestep, 0, {}, RunNumbers{}};
  SteadyMeans& curve = s.numbers->steady_curve;
  for (const char* name : {"front_lead", "rear_lead"}) {
    curve.wheelsets.push_back({name, 1e-3 * factor, 1e-4 * factor, 0, 7000 * factor});
  }
  curve.wheels = {{"front_lead_outer"}, {"front_lead_inner"}};
  curve.wheels[0].T_gamma_N = 10 * factor;
  curve.wheels[1].T_gamma_N = 20 * factor;
  curve.bogies = {{"front_", 2e-4 * factor}};
  curve.cylinders = {{"front_1"}};
  curve.cylinders[0].piston_m = 1e-3 * factor;
  s.numbers->run.T_gamma_total_J = 5000 * factor;
  s.numbers->run.steps = 100;
  s.numbers->budget = {{"front_lead", 100 * factor}};
  return s;
}

RunOutcome Recorded() {
  RunOutcome run;
  const auto add = [&run](const char* name, std::vector<double> column) {
    run.channels.push_back({name, "", ""});
    run.columns.push_back(std::move(column));
  };
  add("front_lead_angle_of_attack_rad", {0, -4e-3, 1e-4});
  add("front_trail_angle_of_attack_rad", {0, 1e-3, 1e-4});
  add("rear_lead_angle_of_attack_rad", {0, -5e-4, 1e-4});
  add("front_bending_rad", {0, 2e-3, 2e-4});
  add("front_cylinder_1_piston_m", {0, 2e-3, 1e-3});
  add("front_lead_steering_moment_Nm", {0, 1000, 100});
  return run;
}

Json ChangesOf(double factor) {
  return DiscretisationJson(ChangesAtHalfStep(Recorded(), Summary(1e-3, factor), Summary(5e-4, 1)));
}

TEST(DiscretisationTest, NumbersThatChangeSignAreJudgedByTheirLargestOnThatBogie) {
  const Json d = ChangesOf(1.1);
  const Json& changes = d["changes"];
  const Json& front = changes["steady_curve.wheelsets.front_lead.angle_of_attack_rad"];
  EXPECT_DOUBLE_EQ(front["value"], 1.1e-4);
  EXPECT_DOUBLE_EQ(front["half_step"], 1e-4);
  EXPECT_NEAR(front["relative"].get<double>(), 0.1, 1e-12);
  EXPECT_NEAR(front["of_scale"].get<double>(), 0.1e-4 / 4e-3, 1e-12);
  EXPECT_EQ(front["scale"], 4e-3);
  const Json& rear = changes["steady_curve.wheelsets.rear_lead.angle_of_attack_rad"];
  EXPECT_NEAR(rear["of_scale"].get<double>(), 0.1e-4 / 5e-4, 1e-12);
  EXPECT_NEAR(changes["steady_curve.front_bending_rad"]["of_scale"].get<double>(), 0.01, 1e-12);
  EXPECT_NEAR(changes["steady_curve.cylinders.front_1.piston_m"]["of_scale"].get<double>(), 0.05,
              1e-12);
  EXPECT_NEAR(changes["budget.front_lead.creep_Nm"]["of_scale"].get<double>(), 0.01, 1e-12);
}

TEST(DiscretisationTest, ForcesAndWearAreJudgedByTheirOwnSize) {
  const Json d = ChangesOf(1.03);
  const Json& changes = d["changes"];
  for (const char* name : {"steady_curve.wheelsets.front_lead.sum_Y_N", "run.T_gamma_total_J",
                           "steady_curve.wheels.front_lead_outer.T_gamma_N"}) {
    EXPECT_TRUE(changes[name]["of_scale"].is_null()) << name;
    EXPECT_NEAR(JudgedChange(changes[name]), 0.03, 1e-12) << name;
    EXPECT_THAT(d["moving"], Contains(name));
  }
  EXPECT_DOUBLE_EQ(changes["steady_curve.T_gamma_N"]["half_step"], 30);
  EXPECT_FALSE(changes.contains("run.steps"));
  EXPECT_THAT(d["moving"], Not(Contains("budget.front_lead.creep_Nm")));
  EXPECT_EQ(d["timestep_s"], 1e-3);
  EXPECT_EQ(d["half_step_s"], 5e-4);
}

TEST(DiscretisationTest, TwoPerCentIsTheBorder) {
  const Json below = ChangesOf(1.019);
  EXPECT_TRUE(below["moving"].empty()) << below["moving"];
  const Json beyond = ChangesOf(0.979);
  EXPECT_FALSE(beyond["moving"].empty());
}

TEST(DiscretisationTest, WhatIsAsGoodAsNothingAtBothStepsDoesNotMove) {
  RunSummary value = Summary(1e-3, 1), half = Summary(5e-4, 1);
  const auto moving = [&](double y_value, double y_half) {
    value.numbers->steady_curve.wheels[0].Y_N = y_value;
    half.numbers->steady_curve.wheels[0].Y_N = y_half;
    return DiscretisationJson(ChangesAtHalfStep(Recorded(), value, half));
  };
  const std::string name = "steady_curve.wheels.front_lead_outer.Y_N";  // 100 N of a wheel load
  EXPECT_THAT(moving(34.5, 33)["moving"], Not(Contains(name)));
  EXPECT_NEAR(moving(34.5, 33)["changes"][name]["relative"].get<double>(), 34.5 / 33 - 1, 1e-12);
  EXPECT_THAT(moving(-110, 33)["moving"], Contains(name));
  EXPECT_THAT(moving(34, 110)["moving"], Contains(name));
  EXPECT_THAT(moving(1100, 1000)["moving"], Contains(name));
}

TEST(DiscretisationTest, ARunThatEndedEarlyHasNoChanges) {
  RunSummary half;
  half.status = "diverged";
  half.timestep_s = 5e-4;
  const Json d = DiscretisationJson(ChangesAtHalfStep(Recorded(), Summary(1e-3, 1), half));
  EXPECT_EQ(d["half_step_status"], "diverged");
  EXPECT_TRUE(d["changes"].empty());
}

TEST(DiscretisationTest, RatiosMoveByBothTheirNumbers) {
  const StepChanges a = ChangesAtHalfStep(Recorded(), Summary(1e-3, 1.05), Summary(5e-4, 1));
  const StepChanges b = ChangesAtHalfStep(Recorded(), Summary(1e-3, 0.95), Summary(5e-4, 1));
  const Json ratios = DiscretisationJson(RatioChanges({{"phs", a}, {"rigid", b}}));
  const Json& wear = ratios["changes"]["phs_over_rigid.run.T_gamma_total_J"];
  EXPECT_NEAR(wear["value"].get<double>(), 1.05 / 0.95, 1e-12);
  EXPECT_NEAR(wear["relative"].get<double>(), 1.05 / 0.95 - 1, 1e-12);
  EXPECT_THAT(ratios["moving"], Contains("phs_over_rigid.run.T_gamma_total_J"));
  EXPECT_EQ(ratios["timestep_s"], 1e-3);
}

}  // namespace
}  // namespace phs::vehicle
