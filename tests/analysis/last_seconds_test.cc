// What is left at the end of a run: by closed form, and of a damped and an undamped locomotive
// behind a bump.
#include "analysis/last_seconds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/stability.h"
#include "vehicle/scenario_file.h"

namespace phs::analysis {
namespace {

vehicle::Simulation Made(const vehicle::Scenario& scenario) {
  auto made = vehicle::Simulation::Create(scenario);
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().Line());
  return std::move(made).value();
}

TEST(LastSecondsTest, IsTheRootMeanSquareAboutTheMeanOfTheEnd) {
  const vehicle::Simulation simulation = Made(vehicle::LoadScenario("straight").value());
  vehicle::RunOutcome run;
  run.channels = {{"t_s", "s", ""}};
  for (const auto& w : simulation.binding().wheelsets()) {
    run.channels.push_back({w.name + "_sum_Y_N", "N", ""});
    run.channels.push_back({w.name + "_lateral_m", "m", ""});
  }
  run.columns.resize(run.channels.size());
  // Wild at first; then 2 Hz, 3 kN about 5 kN and twice that at the second wheelset; it doubles in
  // the last second of two.
  for (int i = 0; i <= 1000; ++i) {
    const double t = 0.01 * i, size = t < 8 ? 50 : t < 9 ? 1 : 2;
    const double wave = size * std::sin(2 * M_PI * 2 * t);
    run.columns[0].push_back(t);
    for (size_t w = 0; w < 2; ++w) {
      const double factor = static_cast<double>(w + 1);
      run.columns[2 * w + 1].push_back(5e3 + factor * 3e3 * wave);
      run.columns[2 * w + 2].push_back(1e-3 + factor * 1e-4 * wave);
    }
  }
  const LastSeconds left = CalcLastSeconds(simulation, run, 2);
  const double rms = 3e3 * std::sqrt((1 + 4) / 2.0 / 2);
  EXPECT_NEAR(left.wheelsets[0].rms_sum_Y_N, rms, 0.01 * rms);
  EXPECT_NEAR(left.largest_rms_sum_Y_N, 2 * rms, 0.02 * rms);
  EXPECT_NEAR(left.largest_swing_m, 4e-4, 1e-6);
  EXPECT_NEAR(left.rms_grows, 2, 0.03);
  EXPECT_TRUE(std::isnan(CalcLastSeconds(simulation, run, 6).largest_rms_sum_Y_N)) << "too short";
  EXPECT_TRUE(LastSecondsJson(CalcLastSeconds(simulation, run, 6))["rms_grows"].is_null());
  run.status = "derailed";
  EXPECT_TRUE(std::isnan(CalcLastSeconds(simulation, run, 2).largest_rms_sum_Y_N));
}

double LeftBehindTheBump(const std::string& bogie, double speed_km_h) {
  vehicle::Scenario scenario = vehicle::LoadScenario("locomotive_bump").value();
  scenario.bogie = bogie;
  scenario.speed_m_s = speed_km_h / 3.6;
  scenario.duration_s = 15;
  vehicle::Simulation simulation = Made(scenario);
  const auto run = simulation.Run();
  EXPECT_TRUE(run.ok());
  return CalcLastSeconds(simulation, run.value(), 3).largest_rms_sum_Y_N;
}

TEST(LastSecondsTest, TheDampedLocomotiveComesToRestBehindABumpTheUndampedHunts) {
  EXPECT_GT(LeftBehindTheBump("phs", 110), 10e3);
  EXPECT_LT(LeftBehindTheBump("phs_damped", 110), 100);
}

// The yaw dampers of phs_damped are, at small motion, those of a joint with 2 c e^2.
TEST(DampedLocomotiveTest, YawDampersAreTheDampingOfTheJointBetweenBodyAndBogie) {
  vehicle::Scenario with = vehicle::LoadScenario("locomotive_bump").value();
  with.track = "straight";
  // Seals that hold nothing and open throttles: hunting grows at 33 m/s and the dampers matter.
  with.phs_changes.parameters = {{"friction.stiffness_N_per_m", 1e5},
                                 {"effects.throttle.laminar_Pas_per_m3", 1e6},
                                 {"effects.throttle.turbulent_Pas2_per_m6", 0}};
  vehicle::Scenario joints = with;
  joints.bogie = "phs";
  joints.phs = "bo_bo_damped";
  for (const char* joint : {"front_secondary_yaw", "rear_secondary_yaw"}) {
    joints.joints.push_back({joint, -1, 5e4 + 2 * 1.0e5 * 1.2 * 1.2});
  }
  vehicle::Scenario without = joints;
  without.joints.clear();
  const auto growth = [](const vehicle::Scenario& scenario) {
    vehicle::Simulation simulation = Made(scenario);
    const auto spectrum = SpectrumAt(&simulation, 33);
    EXPECT_TRUE(spectrum.ok());
    return spectrum.value().growth;
  };
  const double own = growth(with), same = growth(joints), none = growth(without);
  EXPECT_NEAR(own, same, 0.03 * std::abs(none - same));
  EXPECT_GT(none - same, 0.1) << "the dampers take growth away";
}

// A turbulent throttle is probed within its linear part: a step of 1 ms is found to be stable.
TEST(DampedLocomotiveTest, ATurbulentThrottleStands) {
  vehicle::Scenario scenario = vehicle::LoadScenario("straight").value();
  scenario.phs_changes.effects.push_back(
      {"throttle", {}, {{"laminar_Pas_per_m3", 2e9}, {"turbulent_Pas2_per_m6", 1e14}}});
  EXPECT_GT(Made(scenario).largest_stable_step(), 1e-3);
}

}  // namespace
}  // namespace phs::analysis
