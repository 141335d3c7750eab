// What a step costs: MuJoCo's own, with the callbacks, by bogie and creep law. Ratios in one run
// are what counts; machines differ.
#include <benchmark/benchmark.h>

#include "plugin/registry.h"
#include "plugin/settle.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {
namespace {

Scenario InTheCurve(const std::string& bogie, const std::string& creep) {
  Scenario s;
  s.name = "bench";
  s.track = "curve_r550";
  s.bogie = bogie;
  s.creep = creep;
  s.wheel = "S1002";
  s.rail = "UIC60";
  s.speed_m_s = 80 / 3.6;
  return s;
}

/// Steps a bogie round the curve; starts again at the end of the arc.
void StepWithPhysics(benchmark::State& state, const std::string& bogie, const std::string& creep) {
  auto sim = Simulation::Create(InTheCurve(bogie, creep));
  if (!sim.ok()) {
    state.SkipWithError(sim.error().Line().c_str());
    return;
  }
  const mjModel* m = sim.value().model();
  mjData* d = sim.value().data();
  double simulated = 0;
  for (auto _ : state) {
    if (d->qpos[0] > 420) {
      state.PauseTiming();
      plugin::ResetToStart(m, d);
      state.ResumeTiming();
    }
    mj_step(m, d);
    simulated += m->opt.timestep;
  }
  state.counters["times_real_time"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}

/// The same model without the plugin: the bogie falls freely, MuJoCo does the same work.
void StepBare(benchmark::State& state, const std::string& bogie) {
  auto sim = Simulation::Create(InTheCurve(bogie, "linear"));
  if (!sim.ok()) {
    state.SkipWithError(sim.error().Line().c_str());
    return;
  }
  mjModel* m = sim.value().mutable_model();
  mjData* d = sim.value().data();
  plugin::Detach(m);
  for (auto _ : state) {
    if (d->time > 1) {
      state.PauseTiming();
      mj_resetData(m, d);
      state.ResumeTiming();
    }
    mj_step(m, d);
  }
}

BENCHMARK_CAPTURE(StepBare, phs, "phs");
BENCHMARK_CAPTURE(StepBare, rigid_link, "rigid_link");
BENCHMARK_CAPTURE(StepWithPhysics, phs_kalker_table, "phs", "kalker_table");
BENCHMARK_CAPTURE(StepWithPhysics, rigid_link_kalker_table, "rigid_link", "kalker_table");
BENCHMARK_CAPTURE(StepWithPhysics, phs_linear, "phs", "linear");
BENCHMARK_CAPTURE(StepWithPhysics, phs_polach, "phs", "polach");
BENCHMARK_CAPTURE(StepWithPhysics, phs_fastsim, "phs", "fastsim");

}  // namespace
}  // namespace phs::vehicle

BENCHMARK_MAIN();
