// Where the time of an identification goes: one run of the rig model with different effects in it,
// on the whole record and on the coarse one, and the whole search. 120 s at 200 Hz.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "identify/models/rig_forward.h"
#include "identify/select/effect_search.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {
namespace {

using measurement::FitData;
using measurement::SmoothPosition;

constexpr double kStep = 0.005, kNoise = 5e-7;

hydraulics::PhsParams Quarter(const std::string& effect) {
  hydraulics::PhsParams params = phs_model::FindPhsParams("quarter_setup2").value();
  if (!effect.empty()) PHS_CHECK(phs_model::AddEffect(&params, effect).ok());
  return params;
}

/// Sines of two speeds and rests, as a rig of `truth` would measure them.
FitData Record(const hydraulics::PhsParams& truth) {
  FitData data;
  data.step_s = kStep;
  data.estimation = {0, 75};
  data.validation = {75, 120};
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  rigs::RigMotion motion{0, kStep, {{}}, {}, {}, {}, {}};
  for (int i = 0; i < 24000; ++i) {
    const double t = i * kStep, phase = std::fmod(t, 20.0);
    data.time_s.push_back(t);
    motion.position_m[0].push_back(
        phase < 16 ? 2e-3 * std::sin(2 * M_PI * phase / 4) + 4e-4 * std::sin(2 * M_PI * phase) : 0);
  }
  rigs::RigPrediction clean;
  const auto rig = rigs::RigModel::Create(rigs::RigKind::kQuarter, truth);
  PHS_CHECK(rig.value().Run(motion, &clean).ok());
  data.inputs.push_back({"actuator_m", motion.position_m[0], kNoise});
  for (double& x : data.inputs[0].values) x += kNoise * normal(random);
  data.motion.push_back(SmoothPosition(data.inputs[0].values, {}, kStep, kNoise));
  const double noise[] = {1.5e-6, 40, 1e4, 1e4};
  for (size_t c = 0; c < 4; ++c) {
    data.outputs.push_back({rig.value().output_names()[c], clean.channels[c], noise[c]});
    for (double& y : data.outputs.back().values) y += noise[c] * normal(random);
  }
  return data;
}

/// `step_s` > 0: on a coarse clock.
FitProblem ProblemOf(const FitData& data, double step_s = 0) {
  std::shared_ptr<const ForwardModel> rig = RigForward::Create(data, Quarter("")).value();
  if (step_s > 0) rig = rig->Coarse(step_s);
  return FitProblem::Create(rig, Quarter("")).value();
}

void RunModel(benchmark::State& state, const std::string& effect, int stride) {
  const FitData data = Record(Quarter(""));
  const FitProblem problem = ProblemOf(data, stride > 1 ? stride * kStep : 0);
  const FreeModel model = DeclaredModel(Quarter(effect));
  std::vector<double> values;
  for (const FreeParameter& p : model.free) values.push_back(p.start);
  // Each run with other oil: what a model has run with is kept (RunMemory).
  const double oil = values.front();
  int runs = 0;
  for (auto _ : state) {
    values.front() = oil * (1 + 1e-6 * (++runs % 1000));
    benchmark::DoNotOptimize(problem.Residual(model, values));
  }
}

void Search(benchmark::State& state, const std::string& hidden) {
  const FitData data = Record(Quarter(hidden));
  for (auto _ : state) {
    FitProblem problem = ProblemOf(data);
    benchmark::DoNotOptimize(Identify(&problem, Quarter(""), {}, nullptr));
  }
}

BENCHMARK_CAPTURE(RunModel, declared, "", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunModel, declared_coarse, "", 4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunModel, hose_expansion, "hose_expansion", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunModel, line_inertance, "line_inertance", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(RunModel, mount_compliance, "mount_compliance", 1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Search, nothing_hidden, "")->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(Search, stribeck, "stribeck")->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(Search, mount_compliance, "mount_compliance")
    ->Unit(benchmark::kSecond)
    ->Iterations(1);

}  // namespace
}  // namespace phs::identify::search

BENCHMARK_MAIN();
