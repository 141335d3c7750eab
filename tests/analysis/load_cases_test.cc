// Loads on the axle boxes against hand statics.
#include "analysis/load_cases.h"

#include <gmock/gmock.h>

#include <cmath>

#include "analysis/axle_modes.h"
#include "analysis/axle_pattern.h"

namespace phs::analysis {
namespace {

vehicle::Simulation Standing(const std::string& bogie) {
  vehicle::Scenario s;
  s.name = "loads";
  s.bogie = bogie;
  s.track = "straight";
  s.speed_m_s = 20;
  auto sim = vehicle::Simulation::Create(s);
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  return std::move(sim).value();
}

TEST(LoadCasesTest, SpringsAndCylindersTogetherCarryTheLoad) {
  // bo_bo_measured is filled out of balance: without load springs and cylinders hold each other.
  const vehicle::Simulation sim = Standing("phs");
  auto cases = StandardLoadCases();
  cases.insert(cases.begin(), {"none", "traction", 0, ""});
  auto results = CalcLoadCases(sim, cases);
  ASSERT_TRUE(results.ok()) << results.error().Line();
  const LoadState& none = results.value()[0].end;
  const double preload = none.force_N[0] + none.force_N[1];
  EXPECT_LT(std::abs(preload), 2.0e6 * 1e-4) << "within 0.1 mm of the springs' rest";
  EXPECT_NEAR(none.force_N[2] + none.force_N[3], preload, 1e-2);
  for (const LoadResult& r : results.value()) {
    if (r.load_case.pattern == "shear") continue;
    const double sign = r.load_case.pattern == "traction" ? 1 : -1;
    // Lead cylinders pull back when the axle goes forward, trail cylinders push forward by -F.
    const double lead = 2 * sign * r.load_case.load_N - 2.0e6 * r.end.x_m[0] -
                        (r.end.force_N[0] + r.end.force_N[1] - preload);
    const double trail = 2 * sign * r.load_case.load_N - 2.0e6 * r.end.x_m[1] +
                         (r.end.force_N[2] + r.end.force_N[3] - preload);
    EXPECT_NEAR(lead, 0, 20) << r.load_case.name;
    EXPECT_NEAR(trail, 0, 20) << r.load_case.name;
  }
}

TEST(LoadCasesTest, SmallLoadsFollowTheClosedFormOfTheTractionMode) {
  // Both axles by u: 4 boxes of P against springs 2 kx and the PHS 8 A_rod^2/C_cross.
  const vehicle::Simulation sim = Standing("phs_declared");
  auto results = CalcLoadCases(sim, {{"small", "traction", 200, ""}});
  ASSERT_TRUE(results.ok());
  const double rod = M_PI / 4 * (0.1 * 0.1 - 0.032 * 0.032);
  const double C = 1.1e-3 / 1.4e9 + 16.16e-6 / 2.005347e6;
  const double stiffness = 2 * 2.0e6 + 8 * rod * rod / C;
  const auto& x = results.value()[0].end.x_m;
  EXPECT_NEAR((x[0] + x[1]) / 2 / (4 * 200 / stiffness), 1, 0.02);
}

// Throttles divide the oil of a line and exert nothing at rest: the same axles, pistons and lines.
TEST(LoadCasesTest, ThrottledChambersHoldWhatTheirLinesHold) {
  const auto cases = StandardLoadCases();
  std::vector<std::vector<LoadResult>> results;
  for (const char* bogie : {"phs", "phs_damped"}) {
    auto made = CalcLoadCases(Standing(bogie), cases);
    ASSERT_TRUE(made.ok()) << made.error().Line();
    results.push_back(std::move(made).value());
  }
  for (size_t k = 0; k < cases.size(); ++k) {
    const LoadState &plain = results[0][k].end, &throttled = results[1][k].end;
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(throttled.x_m[i], plain.x_m[i], 2e-6) << cases[k].name;
      EXPECT_NEAR(throttled.yaw_rad[i], plain.yaw_rad[i], 2e-6) << cases[k].name;
    }
    for (size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(throttled.pressure_Pa[i], plain.pressure_Pa[i],
                  2e-3 * plain.pressure_Pa[i] + 500);
    }
  }
}

// The pressures of a held load alone change what the lines add: sum of w^2/C, C = V/beta + p_0 V_0/p^2
// of an isothermal gas (mode_closed_form.h), w = 2 b A_bore for each diagonal; none for the others.
TEST(HeldShearTest, FollowsThePressuresOfTheHeldLoad) {
  vehicle::Scenario scenario;
  scenario.name = "held";
  scenario.bogie = "phs";
  scenario.phs = "bo_bo";
  scenario.track = "straight";
  scenario.speed_m_s = 20;
  const auto sim = vehicle::Simulation::Create(scenario);
  ASSERT_TRUE(sim.ok());
  const auto held = CalcHeldShear(sim.value(), {{"pull", "traction", 30e3, ""}});
  ASSERT_TRUE(held.ok()) << held.error().Line();
  const HeldLoad& rest = held.value().rest;
  const HeldLoad& pull = held.value().cases[0];
  const double w = 2 * BoxLever(sim.value().model()) * M_PI / 4 * 0.1 * 0.1;
  const auto lines = [&](const HeldLoad& of) {
    double sum = 0;
    for (const int line : {1, 2}) {
      const double p = of.state.pressure_Pa[static_cast<size_t>(line)];
      sum += w * w / (1.1e-3 / 1.4e9 + 16.16e-6 * 1.8e6 / (p * p));
    }
    return sum;
  };
  const double at_rest = rest.shear_stiffness_Nm_per_rad;
  const double held_K = pull.shear_stiffness_Nm_per_rad;
  EXPECT_GT(lines(pull), 2 * lines(rest)) << "the diagonals rise";
  EXPECT_NEAR((held_K - at_rest) / (lines(pull) - lines(rest)), 1, 0.02);
  EXPECT_NEAR(rest.state.pressure_Pa[1], 1.8e6, 1);
  EXPECT_TRUE(pull.held);
}

TEST(HeldShearTest, AtRestIsTheSmallShearModeWithoutSeals) {
  const vehicle::Simulation sim = Standing("phs_declared");  // filled in balance
  const auto modes = MeasureAxleModes(sim);
  const auto held = CalcHeldShear(sim, {});
  ASSERT_TRUE(modes.ok() && held.ok());
  const ModeClosedForm& form = modes.value().small[1].closed_form;
  const double K = held.value().rest.shear_stiffness_Nm_per_rad;
  EXPECT_NEAR(K / (form.springs + form.lines), 1, 0.01);
}

TEST(LoadCasesTest, TractionAndBrakingMirrorEachOther) {
  const vehicle::Simulation sim = Standing("phs");
  auto results =
      CalcLoadCases(sim, {{"pull", "traction", 40e3, ""}, {"brake", "braking", 40e3, ""}});
  ASSERT_TRUE(results.ok());
  const LoadState& pull = results.value()[0].end;
  const LoadState& brake = results.value()[1].end;
  EXPECT_NEAR(pull.x_m[0], -brake.x_m[1], 1e-8);
  EXPECT_NEAR(pull.force_N[0], brake.force_N[2], 1);
  EXPECT_NEAR(pull.pressure_Pa[0], brake.pressure_Pa[3], 100);
}

TEST(LoadCasesTest, ABogieWithoutCylindersIsRefused) {
  const vehicle::Simulation sim = Standing("rigid_link");
  auto results = CalcLoadCases(sim, StandardLoadCases());
  ASSERT_FALSE(results.ok());
  EXPECT_THAT(results.error().Line(), testing::HasSubstr("has no PHS"));
}

}  // namespace
}  // namespace phs::analysis
