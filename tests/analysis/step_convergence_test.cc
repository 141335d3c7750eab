// Numbers of a run at the step of the shipped scenarios against half of it. The step is of second order
// (StepOrderTest), so that four thirds of the change is what the step errs.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::map<std::string, double>;

void Collect(const Json& json, const std::string& path, Numbers* out) {
  if (json.is_number()) (*out)[path] = json.get<double>();
  if (!json.is_structured()) return;
  size_t index = 0;
  for (const auto& [key, value] : json.items()) {
    const std::string name =
        json.is_array()
            ? (value.contains("name") ? value["name"].get<std::string>() : std::to_string(index))
            : key;
    Collect(value, std::string(path).append("/").append(name), out);
    ++index;
  }
}

Numbers RunAt(Scenario scenario, double step) {
  scenario.timestep_s = step;
  auto sim = Simulation::Create(scenario);
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run();
  EXPECT_TRUE(run.ok());
  EXPECT_EQ(run.value().status, "ok") << run.value().reason;
  const Json summary = SummaryJson(Summarise(sim.value(), run.value()));
  Numbers numbers;
  Collect(summary["steady_curve"], "", &numbers);
  Collect(summary["run"], "/run", &numbers);
  // What a seal's force is measured in: its largest size in the run, which a steady curve may not show.
  for (size_t i = 0; i < run.value().columns.size(); ++i) {
    if (!run.value().channels[i].name.ends_with("_friction_N")) continue;
    double& largest = numbers["/largest/friction_N"];
    for (const double x : run.value().columns[i]) largest = std::max(largest, std::abs(x));
  }
  return numbers;
}

/// What these numbers are measured in: those that change sign go by their largest size.
bool ChangesSign(const std::string& name) {
  for (const char* part : {"angle_of_attack", "yaw_rad", "lateral_m", "bending", "shear", "piston",
                           "moment", "friction_N", "force_N", "_X_N", "/X_N"}) {
    if (name.find(part) != std::string::npos) return true;
  }
  return false;
}

/// Sizes that signed numbers are measured in: the largest of the same kind in the run.
std::map<std::string, double> Scales(const Numbers& numbers) {
  std::map<std::string, double> scales;
  for (const auto& [name, value] : numbers) {
    double& scale = scales[name.substr(name.rfind('/'))];
    scale = std::max(scale, std::abs(value));
  }
  return scales;
}

/// Below this a number is as good as nothing beside its kind: a thousandth of the wheel load for Y,
/// 0.1 N for T-gamma (a steered axle has some N).
double AsGoodAsNothing(const std::string& name) {
  if (name.ends_with("/Y_N")) return 100;
  if (name.ends_with("/Y_over_Q")) return 1e-3;
  return name.find("T_gamma") != std::string::npos ? 0.1 : 1e-7;
}

/// Bookkeeping, not physics; and single maxima, which are listed by phs --verify instead.
bool IsJudged(const std::string& name) {
  for (const char* part : {"steps", "end_time", "energy_error", "_s_m", "work_in", "lost_",
                           "/run/m", "_energy", "/largest"}) {
    if (name.find(part) != std::string::npos) return false;
  }
  return true;
}

/// The step that a shipped scenario says.
double ShippedStep(const std::string& name) {
  const auto scenario = LoadScenario(name);
  EXPECT_TRUE(scenario.ok()) << scenario.error().Line();
  return scenario.value().timestep_s;
}

/// Every number changes by at most `share` under half the step, signed ones by `share_of_scale`.
void ExpectConverged(const Scenario& scenario, double share, double share_of_scale) {
  const double step = scenario.timestep_s > 0 ? scenario.timestep_s : ShippedStep("curve_r550");
  const Numbers coarse = RunAt(scenario, step);
  const Numbers fine = RunAt(scenario, step / 2);
  const auto scales = Scales(fine);
  int judged = 0;
  for (const auto& [name, value] : coarse) {
    if (!IsJudged(name) || !fine.contains(name)) continue;
    ++judged;
    const double change = 4.0 / 3.0 * std::abs(value - fine.at(name));
    if (ChangesSign(name)) {
      EXPECT_LE(change, share_of_scale * scales.at(name.substr(name.rfind('/')))) << name;
    } else {
      EXPECT_LE(change, share * std::max(std::abs(fine.at(name)), AsGoodAsNothing(name))) << name;
    }
  }
  EXPECT_GT(judged, 30);
}

Scenario Curve(const std::string& track, double speed_km_h, const std::string& bogie) {
  Scenario s;
  s.name = "convergence";
  s.track = track;
  s.bogie = bogie;
  s.speed_m_s = speed_km_h / 3.6;
  return s;
}

TEST(StepConvergenceTest, SmoothCurvesWithinOnePercentOfTheirLimit) {
  for (const auto& [track, speed] :
       {std::pair{"curve_r300", 60.0}, std::pair{"curve_r550", 80.0}, std::pair{"curve_r800", 80.0},
        std::pair{"curve_r2000", 80.0}}) {
    for (const char* bogie : {"phs", "rigid_link"}) {
      SCOPED_TRACE(std::string(track) + " " + bogie);
      ExpectConverged(Curve(track, speed, bogie), 0.01, 0.002);
    }
  }
}

// Oil behind throttles hardly yields: a flow that lags by half a step shows in the seals here.
TEST(StepConvergenceTest, ThrottledCylindersWithinOnePercentOfTheirLimit) {
  ExpectConverged(Curve("curve_r550", 80, "phs_damped"), 0.01, 0.002);
}

// A blow on the axles: a drive that holds the speed of half a step ago, or a hose that bursts in
// one step or the next, shows in what the seals hold afterwards.
TEST(StepConvergenceTest, BehindABurstWithinOnePercentOfTheLimit) {
  auto scenario = LoadScenario("burst_L1_r550");
  ASSERT_TRUE(scenario.ok()) << scenario.error().Line();
  ExpectConverged(scenario.value(), 0.01, 0.002);
}

TEST(StepConvergenceTest, WearOnRoughTrackWithinTwoPercentOfItsLimit) {
  // Wheels that bounce on their flanges keep the phase of their blows for a while only: sums over
  // the window, not single numbers.
  const Scenario s = Curve("curve_r550_rough", 80, "phs");
  const auto wear = [](const Numbers& numbers) {
    double sum = 0;
    for (const auto& [name, value] : numbers) {
      if (name.ends_with("/T_gamma_N")) sum += value;
    }
    return sum;
  };
  const double step = ShippedStep("curve_r550_rough");
  const double coarse = wear(RunAt(s, step));
  const double fine = wear(RunAt(s, step / 2));
  EXPECT_GT(fine, 10);
  EXPECT_NEAR(coarse / fine, 1, 0.015);  // four thirds of it is 2 %
}

TEST(StepConvergenceTest, TheLocomotiveWithinOnePercentOfItsLimit) {
  Scenario s = Curve("curve_r550", 80, "phs");
  s.vehicle = "locomotive";
  ExpectConverged(s, 0.01, 0.002);
}

}  // namespace
}  // namespace phs::vehicle
