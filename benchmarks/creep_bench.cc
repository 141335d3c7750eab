// Cost of one creep force by law. "one_place": a contact that changes little, as in a simulation;
// "anywhere": creepages and shapes at random, so that the table is not in the cache.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "rail/creep_law.h"

namespace phs::rail {
namespace {

constexpr std::size_t kInputs = 4096;  // a power of two

/// Patches of a 26 t axle, from tread to flange.
std::vector<CreepInput> Anywhere() {
  std::mt19937 random(7);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random);
  };
  std::vector<CreepInput> inputs(kInputs);
  for (CreepInput& in : inputs) {
    in.a = between(3e-3, 10e-3);
    in.b = between(2e-3, 8e-3);
    in.normal = between(20e3, 130e3);
    in.xi = between(-4e-3, 4e-3);
    in.eta = between(-6e-3, 6e-3);
    in.phi = between(-2, 2);
    in.friction = between(0.1, 0.4);
  }
  return inputs;
}

std::vector<CreepInput> OnePlace() {
  CreepInput in{6e-3, 5e-3, 100e3, 1e-3, 1.5e-3, 0.2, 20, 0.3};
  std::vector<CreepInput> inputs(kInputs, in);
  for (std::size_t i = 0; i < kInputs; ++i) inputs[i].xi += 1e-9 * static_cast<double>(i);
  return inputs;
}

void CallLaw(benchmark::State& state, const std::string& method,
             const std::vector<CreepInput>& inputs) {
  CreepLawParams params;
  params.method = method;
  const auto law = CreateCreepLaw(params);
  if (!law.ok()) {
    state.SkipWithError(law.error().Line().c_str());
    return;
  }
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(law.value()->Calc(inputs[i & (kInputs - 1)]));
    ++i;
  }
}

/// Start-up of the default law without a table on the disk.
void BuildTable(benchmark::State& state) {
  CreepLawParams params;
  params.use_disk_cache = false;
  for (auto _ : state) {
    benchmark::DoNotOptimize(CreateCreepLaw(params));
  }
}

const bool kRegistered = [] {
  for (const std::string& method : CreepLawNames()) {
    benchmark::RegisterBenchmark((method + "/one_place").c_str(), CallLaw, method, OnePlace());
    benchmark::RegisterBenchmark((method + "/anywhere").c_str(), CallLaw, method, Anywhere());
  }
  benchmark::RegisterBenchmark("build_table", BuildTable)->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace phs::rail

BENCHMARK_MAIN();
