// Failures of the hydraulics on a running bogie.
#include "phs_model/failures.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/data_path.h"
#include "phs_model/phs_model.h"
#include "plugin/observer.h"
#include "plugin/settle.h"
#include "vehicle/scenario.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::vehicle {
namespace {

using testing::HasSubstr;

Scenario FailingStraight(std::vector<phs_model::Failure> failures) {
  Scenario s;
  s.name = "failure";
  s.track = "straight";
  s.bogie = "phs_declared";  // L2 and L3 at 1.8 MPa, in balance with the cross lines
  s.speed_m_s = 20;
  s.friction.tread = 0.35;
  s.duration_s = 3;
  s.phs_changes.failures = std::move(failures);
  return s;
}

struct Pressures {
  double before, after;
};

/// Pressure of `line` at the first and the last row of a run.
Pressures PressuresOf(const Scenario& scenario, const std::string& line) {
  auto sim = Simulation::Create(scenario);
  EXPECT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run();
  EXPECT_EQ(run.value().status, "ok") << run.value().reason;
  EXPECT_LT(std::abs(run.value().energy.RelativeError()), 5e-3);
  const auto& column =
      run.value().columns[static_cast<size_t>(run.value().Find("line_" + line + "_pressure_Pa"))];
  return {column.front(), column.back()};
}

TEST(FailuresTest, ABurstLineFallsToAtmosphericPressureAtItsTime) {
  const Pressures burst =
      PressuresOf(FailingStraight({{.kind = "line_burst", .line = "L2", .at_s = 1}}), "L2");
  EXPECT_NEAR(burst.before, 1.8e6, 1e4);
  EXPECT_NEAR(burst.after, 101325, 500);
  const Pressures later =
      PressuresOf(FailingStraight({{.kind = "line_burst", .line = "L2", .at_s = 5}}), "L2");
  EXPECT_NEAR(later.after, 1.8e6, 1e4);
}

TEST(FailuresTest, ASlowLeakLosesThePrechargeWithItsTimeConstant) {
  // Pistons held: C dp/dt = -G (p - p_a) with C = V_oil/beta + V_g p0/p^2, from 1.8 MPa.
  const double G = 2e-12;
  auto path = FindData("PHS model", "models/phs", "bo_bo", {".yaml"});
  ASSERT_TRUE(path.ok());
  auto system = phs_model::LoadPhsSystem(
      path.value(), {{}, {{.kind = "line_leak", .line = "L2", .conductance_m3_per_Pas = G}}},
      "bogie", 4);
  ASSERT_TRUE(system.ok());
  const double h = 1e-3;
  std::vector<double> x(4), v(4), pressure(4);
  std::vector<double> state(static_cast<size_t>(system.value().num_states()));
  std::vector<double> rate = state;
  double expected = 1.8e6;
  for (int i = 0; i < 3000; ++i) {
    system.value().CalcStateRate(i * h, h, x.data(), v.data(), state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
    const double C = 1.1e-3 / 1.4e9 + 16.16e-6 * 1.8e6 / (expected * expected);
    expected -= h * G * (expected - 101325) / C;
  }
  hydraulics::PhsOutputs out;
  out.pressure = pressure.data();
  system.value().Calc(3, x.data(), v.data(), state.data(), &out);
  EXPECT_NEAR(pressure[1] / expected, 1, 2e-3);
  EXPECT_LT(pressure[1], 1.3e6);
}

TEST(FailuresTest, LostGasAndAirChangeTheLineFromTheStart) {
  auto params = phs_model::FindPhsParams("bo_bo");
  ASSERT_TRUE(params.ok());
  ASSERT_TRUE(phs_model::ApplyFailures({{.kind = "reservoir_gas_lost", .line = "L3"},
                                        {.kind = "accumulator_gas_lost", .line = "L4"},
                                        {.kind = "air", .line = "L1", .air_m3 = 3e-6}},
                                       "bogie", &params.value())
                  .ok());
  const auto& lines = params.value().lines;
  EXPECT_EQ(lines[2].gas_volume_m3, 0);
  EXPECT_NEAR(lines[2].static_pressure_Pa, 101325, 1);
  EXPECT_NEAR(lines[3].accumulator_precharge_Pa, 101325, 1);
  EXPECT_NEAR(lines[0].free_air_m3, 3e-6, 1e-12);
}

TEST(FailuresTest, LostGasIsNotFilledUpByAnIdentifiedPrecharge) {
  auto params = phs_model::FindPhsParams("bo_bo");
  ASSERT_TRUE(params.ok());
  auto& list = params.value().effects;
  list.push_back({"accumulator_precharge", {}, {{"precharge_Pa", 1.2e7}}});
  list.push_back({"diaphragm_stop", {"L3"}, {{"min_gas_volume_m3", 4e-6}}});
  ASSERT_TRUE(phs_model::ApplyFailures({{.kind = "reservoir_gas_lost", .line = "L3"},
                                        {.kind = "accumulator_gas_lost", .line = "L4"}},
                                       "bogie", &params.value())
                  .ok());
  ASSERT_EQ(list.size(), 1u) << "the stop was of the failed reservoir alone";
  EXPECT_THAT(list[0].targets, testing::ElementsAre("L1", "L2", "L3"));
}

TEST(FailuresTest, OneBogieOfALocomotiveMayFailAlone) {
  Scenario s =
      FailingStraight({{.kind = "line_burst", .line = "L1", .system = "rear_bogie", .at_s = 0.2}});
  s.vehicle = "locomotive";
  s.duration_s = 1;
  auto sim = Simulation::Create(s);
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run();
  const auto last = [&](const std::string& channel) {
    return run.value().columns[static_cast<size_t>(run.value().Find(channel))].back();
  };
  EXPECT_NEAR(last("rear_bogie_line_L1_pressure_Pa"), 101325, 1e4);
  EXPECT_NEAR(last("front_bogie_line_L1_pressure_Pa"), 2.005e6, 1e4);
}

TEST(FailuresTest, TheStateOfALeakLivesInMjData) {
  auto sim = Simulation::Create(FailingStraight({{.kind = "line_leak", .line = "L2", .at_s = 0}}));
  ASSERT_TRUE(sim.ok());
  const mjModel* m = sim.value().model();
  const DataPtr a(mj_makeData(m));
  const DataPtr b(mj_makeData(m));
  plugin::ResetToStart(m, a.get());
  for (int i = 0; i < 500; ++i) mj_step(m, a.get());
  mj_copyData(b.get(), m, a.get());
  for (int i = 0; i < 500; ++i) mj_step(m, a.get());
  for (int i = 0; i < 500; ++i) mj_step(m, b.get());
  for (int i = 0; i < m->na; ++i) EXPECT_EQ(a->act[i], b->act[i]);
  plugin::ResetToStart(m, b.get());
  mj_forward(m, b.get());
  EXPECT_NEAR(sim.value().binding().CalcPhs(m, b.get(), 0).pressure[1], 1.8e6, 3e3);
}

TEST(FailuresTest, WrongEntriesAreNamed) {
  auto unknown = Simulation::Create(FailingStraight({{.kind = "line_burst", .line = "L9"}}));
  ASSERT_FALSE(unknown.ok());
  EXPECT_THAT(unknown.error().Line(), HasSubstr("line 'L9': is not in PHS model bo_bo"));
  auto none = Simulation::Create(FailingStraight({{.kind = "accumulator_gas_lost", .line = "L2"}}));
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().Line(), HasSubstr("has no accumulator"));
  auto map = YamlMap::Parse("failures:\n  - {kind: line_brust, line: L1}\n", "s.yaml");
  ASSERT_TRUE(map.ok());
  phs_model::ReadFailures(&map.value(), 20, 1);
  ASSERT_FALSE(map.value().Finish().ok());
  EXPECT_THAT(map.value().Finish().error().Line(), HasSubstr("line_burst"));
}

TEST(FailuresTest, APlaceBecomesATime) {
  auto map = YamlMap::Parse("failures:\n  - {kind: line_burst, line: L1, at_m: 201}\n", "s.yaml");
  ASSERT_TRUE(map.ok());
  const auto failures = phs_model::ReadFailures(&map.value(), 20, 1);
  ASSERT_TRUE(map.value().Finish().ok());
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_DOUBLE_EQ(failures[0].at_s, 10);
}

TEST(FailuresTest, APlaceBeyondTheTrackIsNoPlace) {
  phs_model::Failure burst{.kind = "line_burst", .line = "L1"};
  burst.at_m = 1e6;
  const auto beyond = Simulation::Create(FailingStraight({burst}));
  ASSERT_FALSE(beyond.ok());
  EXPECT_THAT(beyond.error().Line(), HasSubstr("at_m: 1000000 m lies beyond the track straight"));
  auto map = YamlMap::Parse("failures:\n  - {kind: line_burst, line: L1, at_m: -5}\n", "s.yaml");
  phs_model::ReadFailures(&map.value(), 20, 1);
  EXPECT_THAT(map.value().Finish().error().Line(), HasSubstr("at_m: -5 is out of range"));
}

TEST(StableStep, NoStepIsTooLongToBeJudged) {
  Scenario scenario = FailingStraight({});
  for (const double step : {1.0, 0.06, -1e-3}) {
    scenario.timestep_s = step;
    const auto simulation = Simulation::Create(scenario);
    ASSERT_FALSE(simulation.ok()) << step;
    EXPECT_THAT(simulation.error().Line(), HasSubstr("timestep_s: is ")) << step;
  }
}

}  // namespace
}  // namespace phs::vehicle
