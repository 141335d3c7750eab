// Cost of one evaluation of the PHS: Calc and CalcStateRate of the whole Bo-Bo network by gas law
// and friction model, one rig run of 24000 samples, and compiling parameters.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "effects/catalogue.h"
#include "phs_model/phs_model.h"
#include "rigs/rig_model.h"

namespace phs {
namespace {

using hydraulics::FrictionModel;
using hydraulics::PhsOutputs;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;

PhsParams Model(const char* name) { return phs_model::FindPhsParams(name).value(); }

void Evaluate(benchmark::State& bench, const PhsParams& params) {
  const PhsSystem s = std::move(phs_model::CreatePhsSystem(params).value());
  const int n = s.num_cylinders();
  std::vector<double> x(n), v(n), state(s.num_states(), 0.0), rate(s.num_states()), force(n);
  PhsOutputs out;
  out.force = force.data();
  out.energy = false;
  double t = 0;
  const double h = 1e-3;
  for (auto _ : bench) {
    t += h;
    for (int i = 0; i < n; ++i) {
      x[i] = 2e-3 * std::sin(3 * t + i);
      v[i] = 6e-3 * std::cos(3 * t + i);
    }
    s.CalcStateRate(t, h, x.data(), v.data(), state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
    s.Calc(t, x.data(), v.data(), state.data(), &out);
    benchmark::DoNotOptimize(force.data());
  }
}

void BM_BoBo_GasLaw(benchmark::State& bench) {
  PhsParams p = Model("bo_bo");
  for (auto& l : p.lines)
    l.reservoir.law = l.accumulator.law = hydraulics::GasLaws()[bench.range(0)];
  Evaluate(bench, p);
  bench.SetLabel(hydraulics::GasLawNames()[bench.range(0)]);
}
BENCHMARK(BM_BoBo_GasLaw)->DenseRange(0, 3);

void BM_BoBo_Friction(benchmark::State& bench) {
  PhsParams p = Model("bo_bo");
  p.friction.model = static_cast<FrictionModel>(bench.range(0));
  Evaluate(bench, p);
  static const char* names[] = {"none", "static", "presliding"};
  bench.SetLabel(names[bench.range(0)]);
}
BENCHMARK(BM_BoBo_Friction)->DenseRange(0, 2);

void BM_BoBo_Effect(benchmark::State& bench) {
  const auto& info = effects::Catalogue().effects()[bench.range(0)];
  PhsParams p = Model("bo_bo");
  if (!phs_model::AddEffect(&p, info.name).ok()) return;
  Evaluate(bench, p);
  bench.SetLabel(info.name);
}
BENCHMARK(BM_BoBo_Effect)->DenseRange(0, 25);

void BM_QuarterRun24000(benchmark::State& bench) {
  PhsParams p = Model("quarter_setup2");
  if (bench.range(0) == 1) (void)phs_model::AddEffect(&p, "mount_compliance");
  if (bench.range(0) == 2) (void)phs_model::AddEffect(&p, "line_resistance");
  if (bench.range(0) == 3) (void)phs_model::AddEffect(&p, "gas_thermal");
  rigs::RigMotion motion;
  motion.step_s = 0.005;
  motion.position_m.resize(1);
  for (int i = 0; i < 24000; ++i) {
    motion.position_m[0].push_back(1.5e-3 * std::sin(0.01 * i) + 5e-4 * std::sin(0.0371 * i));
  }
  const rigs::RigModel rig = std::move(rigs::RigModel::Create(rigs::RigKind::kQuarter, p).value());
  rigs::RigPrediction out;
  for (auto _ : bench) {
    if (!rig.Run(motion, &out).ok()) return;
  }
  bench.SetItemsProcessed(bench.iterations() * 24000 * 2);  // two lines each
  static const char* names[] = {"declared", "mount_compliance", "line_resistance", "gas_thermal"};
  bench.SetLabel(names[bench.range(0)]);
}
BENCHMARK(BM_QuarterRun24000)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

void BM_Create(benchmark::State& bench) {
  const PhsParams p = Model("quarter_setup2");
  for (auto _ : bench) {
    auto s = phs_model::CreatePhsSystem(p);
    benchmark::DoNotOptimize(s);
  }
}
BENCHMARK(BM_Create);

}  // namespace
}  // namespace phs

BENCHMARK_MAIN();
