// Cost of one wheel on one rail: search, Hertz and creep forces, for typical states of a curve.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "base/data_path.h"
#include "rail/wheel_rail.h"

namespace phs::rail {
namespace {

WheelRail Pair(const std::string& method) {
  WheelRailParams p;
  p.wheel_profile = FindData("wheel profile", "models/profiles", "S1002", {".prw"}).value();
  p.rail_profile = FindData("rail profile", "models/profiles", "UIC60", {".prr"}).value();
  p.creep.method = method;
  return std::move(WheelRail::Create(p)).value();
}

/// Wheelsets between both flanges, with yaw and load as in a curve.
std::vector<WheelsetMotion> States(const WheelRail& pair, double reach) {
  std::vector<WheelsetMotion> states;
  for (int i = 0; i < 256; ++i) {
    const double s = i / 256.0;
    WheelsetMotion m;
    m.lateral = reach * std::sin(40 * s);
    m.yaw = 8e-3 * std::sin(23 * s);
    m.roll = 2e-3 * std::sin(11 * s);
    m.speed = 22;
    m.velocity = {m.speed, 0.02 * std::sin(31 * s), 0};
    const double spin = -m.speed / pair.params().wheel_radius;
    m.rotation = {0, spin, 0};
    // The height at which this wheel carries about 100 kN.
    double low = pair.touching_height() + 0.02;
    double high = pair.touching_height() - 0.02;
    for (int k = 0; k < 40; ++k) {
      m.vertical = 0.5 * (low + high);
      WheelRailForces f;
      pair.Calc(m, Side::kRight, {}, {}, &f);
      (-f.force[2] > 1e5 ? low : high) = m.vertical;
    }
    states.push_back(m);
  }
  return states;
}

void BM_Wheel(benchmark::State& state, const std::string& method, double reach) {
  const WheelRail pair = Pair(method);
  const auto states = States(pair, reach);
  WheelRailForces forces;
  std::size_t i = 0;
  double patches = 0;
  for (auto _ : state) {
    pair.Calc(states[i++ & 255], Side::kRight, {}, {}, &forces);
    patches += forces.count;
    benchmark::DoNotOptimize(forces);
  }
  state.counters["patches"] = patches / static_cast<double>(i);
}
BENCHMARK_CAPTURE(BM_Wheel, tread_linear, "linear", 4e-3);
BENCHMARK_CAPTURE(BM_Wheel, tread_kalker_table, "kalker_table", 4e-3);
BENCHMARK_CAPTURE(BM_Wheel, flange_kalker_table, "kalker_table", 10e-3);
BENCHMARK_CAPTURE(BM_Wheel, tread_polach, "polach", 4e-3);
BENCHMARK_CAPTURE(BM_Wheel, tread_fastsim, "fastsim", 4e-3);

void BM_WheelOnSupport(benchmark::State& state) {
  const WheelRail pair = Pair("kalker_table");
  const auto states = States(pair, 8e-3);
  const RailSupport support{20e6, 5e4, 60e6, 5e4};
  WheelRailForces forces;
  std::size_t i = 0;
  for (auto _ : state) {
    pair.Calc(states[i++ & 255], Side::kRight, {}, support, &forces);
    benchmark::DoNotOptimize(forces);
  }
}
BENCHMARK(BM_WheelOnSupport);

void BM_LiftedWheel(benchmark::State& state) {
  const WheelRail pair = Pair("linear");
  WheelsetMotion m;
  m.vertical = pair.touching_height() - 1e-3;
  WheelRailForces forces;
  for (auto _ : state) {
    pair.Calc(m, Side::kRight, {}, {}, &forces);
    benchmark::DoNotOptimize(forces);
  }
}
BENCHMARK(BM_LiftedWheel);

}  // namespace
}  // namespace phs::rail

BENCHMARK_MAIN();
