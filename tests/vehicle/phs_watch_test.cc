// Limits of the hydraulics: seen when they are passed, with time and place, and not before.
#include "vehicle/phs_watch.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::vehicle {
namespace {

using Kind = PhsWarning::Kind;
using testing::HasSubstr;

Scenario Straight() {
  Scenario s;
  s.name = "watch";
  s.track = "straight";
  s.speed_m_s = 20;
  s.friction.tread = 0.35;
  s.duration_s = 0.5;
  return s;
}

TEST(PhsWatchTest, AnUndisturbedRunPassesNoLimit) {
  auto sim = Simulation::Create(Straight());
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  auto run = sim.value().Run();
  EXPECT_TRUE(run.value().warnings.empty());
  EXPECT_TRUE(SummaryJson(Summarise(sim.value(), run.value()))["warnings"].empty());
}

/// The bogie is bent by hand, further and further: limits come in the order of the hydraulics.
TEST(PhsWatchTest, EveryLimitIsSeenWhereItIsPassed) {
  Scenario scenario = Straight();
  for (const char* line : {"L1", "L4"}) {  // blow-off within reach of the end stops
    scenario.phs_changes.parameters[std::string(line) + ".accumulator_precharge_Pa"] = 5e6;
  }
  auto sim = Simulation::Create(scenario);
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  const mjModel* m = sim.value().model();
  const plugin::Binding& binding = sim.value().binding();
  mjData* d = sim.value().data();
  PhsWatch watch(binding);
  const double clearance = binding.phs()[0].system->params().cylinders[0].end_stop.clearance_m;
  std::map<Kind, bool> ever;
  double time = 0;
  // Yaw raises the lines of the bores, traction those of the rods, which have the accumulators.
  for (int i = 0; i < 600; ++i, time += 0.1) {
    const double way = 2e-4 * (i % 300);
    for (const char* axle : {"lead", "trail"}) {
      const auto place = [&](const char* what) -> double& {
        const int joint = mj_name2id(m, mjOBJ_JOINT, (std::string(axle) + what).c_str());
        return d->qpos[m->jnt_qposadr[joint]];
      };
      place("_yaw") = i < 300 ? way : 0;
      place("_x") = i < 300 ? 0 : way;
    }
    mj_forward(m, d);
    watch.Check(d, time, 0.1);
    const plugin::PhsState state = binding.CalcPhs(m, d, 0);
    std::map<Kind, bool> beyond;
    for (const double x : state.piston) beyond[Kind::kEndStop] |= std::abs(x) > clearance;
    for (const double f : state.force) beyond[Kind::kCylinderForce] |= std::abs(f) > 60e3;
    for (const double p : state.pressure) beyond[Kind::kLowPressure] |= p < 0.1e6;
    for (size_t i = 0; i < state.pressure.size(); ++i) {
      const auto& line = binding.phs()[0].system->params().lines[i];
      beyond[Kind::kBlowOffOpen] |=
          line.accumulator.volume_m3 > 0 && state.pressure[i] > line.accumulator_precharge_Pa;
    }
    std::map<Kind, bool> seen;
    for (const PhsWarning& w : watch.Warnings()) seen[w.kind] = true;
    for (const auto& [kind, is] : beyond) {
      ever[kind] |= is;
      EXPECT_EQ(seen[kind], ever[kind]) << static_cast<int>(kind) << " at " << way;
    }
  }
  std::map<Kind, int> count;
  for (const PhsWarning& w : watch.Warnings()) {
    ++count[w.kind];
    EXPECT_GT(w.first_time_s, 0);
    EXPECT_GE(w.worst_time_s, w.first_time_s);
    EXPECT_GT(w.Excess(w.worst), 0);
    EXPECT_GT(w.duration_s, 0);
  }
  EXPECT_EQ(count[Kind::kEndStop], 4);
  EXPECT_EQ(count[Kind::kCylinderForce], 4);
  EXPECT_GE(count[Kind::kBlowOffOpen], 1);
  EXPECT_GE(count[Kind::kLowPressure], 1);
}

/// A burst line under traction: pistons are drawn out as the records show, and the watch says so.
TEST(PhsWatchTest, ABurstLineUnderTractionIsToldWithTimeAndPlace) {
  Scenario s = Straight();
  s.duration_s = 3;
  s.friction.tread = 0.4;
  s.running = {.active = true, .drive_torque_Nm = 50e3, .begin_s = 0.5, .ramp_s = 0.5};
  s.phs_changes.failures = {{.kind = "line_burst", .line = "L2", .at_s = 0.3}};
  auto sim = Simulation::Create(s);
  ASSERT_TRUE(sim.ok()) << sim.error().Line();
  auto done = sim.value().Run();
  const RunOutcome& run = done.value();
  ASSERT_EQ(run.status, "ok") << run.reason;
  ASSERT_FALSE(run.warnings.empty());
  const auto column = [&run](const std::string& name) {
    return run.columns.at(static_cast<size_t>(run.Find(name)));
  };
  for (const PhsWarning& w : run.warnings) {
    EXPECT_GT(w.first_time_s, 0.3);
    const size_t row = static_cast<size_t>(std::lround(w.worst_time_s / s.record_interval_s));
    EXPECT_NEAR(w.worst_s_m, column("s_m").at(std::min(row, column("s_m").size() - 1)), 0.3);
    const std::string channel = w.IsOfLine()               ? "line_" + w.part + "_pressure_Pa"
                                : w.kind == Kind::kEndStop ? "cylinder_" + w.part + "_piston_m"
                                                           : "cylinder_" + w.part + "_force_N";
    for (const double value : column(channel)) EXPECT_LE(w.Excess(value), w.Excess(w.worst));
  }
  const auto told = SummaryJson(Summarise(sim.value(), run))["warnings"];
  ASSERT_EQ(told.size(), run.warnings.size());
  EXPECT_THAT(told[0]["text"].get<std::string>(), HasSubstr("first at t = "));
  EXPECT_EQ(told[0]["first_s_m"], run.warnings[0].first_s_m);
}

}  // namespace
}  // namespace phs::vehicle
