// What a run says of its own step: changes judged as docs/results.md promises.
#include "vehicle/discretisation.h"

#include <gmock/gmock.h>

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;
using testing::Contains;
using testing::Not;

/// A locomotive with one axle per bogie, all numbers `factor` times those of the run.
Json Summary(double timestep, double factor) {
  const auto wheelset = [&](const char* name, double attack) {
    return Json{{"name", name},
                {"lateral_m", 1e-3 * factor},
                {"angle_of_attack_rad", attack * factor},
                {"sum_Y_N", 7000 * factor}};
  };
  return {{"status", "ok"},
          {"timestep_s", timestep},
          {"steady_curve",
           {{"wheelsets", {wheelset("front_lead", 1e-4), wheelset("rear_lead", 1e-4)}},
            {"wheels",
             {{{"name", "front_lead_outer"}, {"T_gamma_N", 10 * factor}},
              {{"name", "front_lead_inner"}, {"T_gamma_N", 20 * factor}}}},
            {"front_bending_rad", 2e-4 * factor},
            {"cylinders", {{{"name", "front_1"}, {"piston_m", 1e-3 * factor}}}},
            {"lines", Json::array()}}},
          {"run", {{"T_gamma_total_J", 5000 * factor}, {"steps", 100}}},
          {"budget", {{"front_lead", {{"creep_Nm", 100 * factor}}}}}};
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

TEST(DiscretisationTest, NumbersThatChangeSignAreJudgedByTheirLargestOnThatBogie) {
  const Json d = Discretisation(Recorded(), Summary(1e-3, 1.1), Summary(5e-4, 1));
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
  const Json d = Discretisation(Recorded(), Summary(1e-3, 1.03), Summary(5e-4, 1));
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
  const Json below = Discretisation(Recorded(), Summary(1e-3, 1.019), Summary(5e-4, 1));
  EXPECT_TRUE(below["moving"].empty()) << below["moving"];
  const Json beyond = Discretisation(Recorded(), Summary(1e-3, 0.979), Summary(5e-4, 1));
  EXPECT_FALSE(beyond["moving"].empty());
}

TEST(DiscretisationTest, ARunThatEndedEarlyHasNoChanges) {
  const Json half = {{"status", "diverged"}, {"timestep_s", 5e-4}};
  const Json d = Discretisation(Recorded(), Summary(1e-3, 1), half);
  EXPECT_EQ(d["half_step_status"], "diverged");
  EXPECT_TRUE(d["changes"].empty());
}

TEST(DiscretisationTest, RatiosMoveByBothTheirNumbers) {
  Json a = Summary(1e-3, 1.05);
  a["discretisation"] = Discretisation(Recorded(), a, Summary(5e-4, 1));
  Json b = Summary(1e-3, 0.95);
  b["discretisation"] = Discretisation(Recorded(), b, Summary(5e-4, 1));
  const Json ratios = RatioChanges({{"phs", a}, {"rigid", b}});
  const Json& wear = ratios["changes"]["phs_over_rigid.run.T_gamma_total_J"];
  EXPECT_NEAR(wear["value"].get<double>(), 1.05 / 0.95, 1e-12);
  EXPECT_NEAR(wear["relative"].get<double>(), 1.05 / 0.95 - 1, 1e-12);
  EXPECT_THAT(ratios["moving"], Contains("phs_over_rigid.run.T_gamma_total_J"));
}

}  // namespace
}  // namespace phs::vehicle
