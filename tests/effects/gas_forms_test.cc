// The forms of gas that warms as it is compressed, each against its closed formula.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

/// Fast compression of gas alone (stiff oil) with the given numbers of gas_thermal: p V^n against
/// that of the start.
double PowerLawRatio(const std::map<std::string, double>& numbers, double n) {
  PhsParams params = OilWith("gas_thermal", numbers);
  for (auto& l : params.lines) l.gas_volume_m3 = 1e-5, l.oil_volume_m3 = 1e-6;
  for (auto& l : params.lines) l.reservoir.volume_m3 = 1e-3;
  const PhsSystem s = Compile(params);
  const double x = 4e-4;
  const double p0 = params.lines[0].static_pressure_Pa, h = 1e-4;
  std::vector<double> state(s.num_states(), 0.0), rate(state);
  double at = 0;
  const double v = x / (1000 * h);
  for (int i = 0; i < 1000; ++i, at += h * v) {
    s.CalcStateRate(i * h, h, &at, &v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
  }
  Evaluation e(s);
  s.Calc(0.1, &x, &v, state.data(), &e.out);
  const double C = params.lines[0].oil_volume_m3 / params.lines[0].bulk_modulus_Pa;
  const double gas = 1e-5 - x * params.cylinders[0].RodArea() + C * (e.p_rod[0] - p0);
  return e.p_rod[0] / (p0 * std::pow(1e-5 / gas, n));
}

constexpr double kAdiabaticRise = 296.797 / 742.2;  // R/c_v of nitrogen

TEST(GasForms, FillerKeepsTheGasNearTheTemperatureOfItsSurroundings) {
  // Fast and with a long time constant: an exponent 1 + R/(c_v r), gas alone (V_oil stiff).
  EXPECT_NEAR(
      PowerLawRatio({{"thermal_time_s", 1e6}, {"heat_capacity_ratio", 4}}, 1 + kAdiabaticRise / 4),
      1, 2e-3);
  // A gas of single atoms: 5/3.
  EXPECT_NEAR(PowerLawRatio({{"thermal_time_s", 1e6}, {"heat_capacity_ratio", 0.6}}, 5.0 / 3), 1,
              2e-3);
}

TEST(GasForms, AWallThatLosesNothingActsAsAFillerAndOneThatLosesAllAsSurroundings) {
  // Gas and wall at one temperature: heat capacity 1 + 1/r of the gas's.
  std::map<std::string, double> wall = {
      {"thermal_time_s", 2e-4}, {"wall_heat_ratio", 0.5}, {"wall_time_s", 1e6}};
  EXPECT_NEAR(PowerLawRatio(wall, 1 + kAdiabaticRise / 3), 1, 2e-3);
  wall["wall_time_s"] = 1e-3;
  EXPECT_NEAR(PowerLawRatio(wall, 1), 1, 2e-3);
}

TEST(GasForms, AccumulatorsMayKeepToTheirSurroundingsWhileReservoirsDoNot) {
  // Pushed far beyond the precharge at once: with a short time constant of its own p V = const in
  // the accumulator, whatever the reservoir's gas does.
  PhsParams params = OilWith("gas_thermal", {{"thermal_time_s", 10}, {"accumulator_ratio", 1e-4}});
  for (auto& l : params.lines) l.oil_volume_m3 = 1e-6;
  params.lines[1].gas_volume_m3 = 1e-5;
  params.lines[1].reservoir.volume_m3 = 1e-3;
  auto& rod = params.lines[0];
  rod.accumulator.volume_m3 = 1e-5;
  rod.accumulator_precharge_Pa = 3e6;
  const double x = 4e-4, h = 1e-4;
  const Held at =
      Drive(Compile(params), 0.1, h, [=](double t) { return x * std::min(t / 0.1, 1.0); });
  const double oil = rod.oil_volume_m3 / rod.bulk_modulus_Pa * (at.p_rod - rod.static_pressure_Pa);
  const double gas = 1e-5 - (x * params.cylinders[0].RodArea() - oil);
  EXPECT_NEAR(at.p_rod * gas / (3e6 * 1e-5), 1, 3e-3);
  // The reservoir of the other line is adiabatic meanwhile (but for 0.1 s of 10 s).
  const auto& bore = params.lines[1];
  const double swept =
      x * params.cylinders[0].BoreArea() +
      bore.oil_volume_m3 / bore.bulk_modulus_Pa * (at.p_bore - bore.static_pressure_Pa);
  const double n = 1 + kAdiabaticRise;
  EXPECT_NEAR(at.p_bore / bore.static_pressure_Pa * std::pow((1e-5 + swept) / 1e-5, n), 1, 5e-3);
}

// Warmed by compression, then held: T - T_s falls with tau = tau_0 (V/V_0)^m at constant volume.
TEST(GasForms, HeatGoesFasterOrSlowerWhereTheGasIsDense) {
  const double tau = 2, x = 4e-4;
  for (const double m : {0.7, -0.67}) {
    PhsParams params = OilWith("gas_thermal", {{"thermal_time_s", tau}, {"density_exponent", m}});
    for (auto& l : params.lines) l.gas_volume_m3 = 1e-5, l.oil_volume_m3 = 1e-6;
    for (auto& l : params.lines) l.reservoir.volume_m3 = 1e-3;
    const PhsSystem s = Compile(params);
    const auto push = [=](double t) { return x * std::min(t / 0.01, 1.0); };
    const Held early = Drive(s, 0.02, 1e-3, push), late = Drive(s, 1.02, 1e-3, push);
    const double denser = 1e-5 / (1e-5 - x * params.cylinders[0].RodArea());
    const size_t rod = 0;
    ASSERT_GT(early.state[rod], 10) << "compressed gas is warm";
    EXPECT_NEAR(std::log(early.state[rod] / late.state[rod]), std::pow(denser, m) / tau, 5e-3) << m;
  }
}

TEST(GasForms, AGasAndItsWallStayStableInStepsFarBeyondTheirTime) {
  // h = 5 ms, tau = 0.1 ms, the wall nearly insulated: gas and wall at one temperature.
  PhsParams params = OilWith(
      "gas_thermal", {{"thermal_time_s", 1e-4}, {"wall_heat_ratio", 1}, {"wall_time_s", 1e4}});
  for (auto& l : params.lines) l.gas_volume_m3 = 1e-5, l.oil_volume_m3 = 1e-6;
  for (auto& l : params.lines) l.reservoir.volume_m3 = 1e-3;
  const double x = 4e-4;
  const Held at = Drive(Compile(params), 1, 5e-3, [=](double t) { return x * t; });
  const auto& rod = params.lines[0];
  const double oil = rod.oil_volume_m3 / rod.bulk_modulus_Pa * (at.p_rod - rod.static_pressure_Pa);
  const double gas = 1e-5 - x * params.cylinders[0].RodArea() + oil;
  EXPECT_NEAR(at.p_rod / (rod.static_pressure_Pa * std::pow(1e-5 / gas, 1 + kAdiabaticRise / 2)), 1,
              2e-3);
}

TEST(GasForms, AGasBehindAPipeThatHardlyResistsIsAGasBesideNone) {
  // The flow settles within microseconds, the heat follows it; steps of 5 ms, mean over 2 s.
  const std::map<std::string, double> heat = {{"thermal_time_s", 7.7},
                                              {"heat_capacity_ratio", 1.3}};
  const PhsParams beside = With(Frictionless(), "gas_thermal", heat);
  const auto motion = [](double t) { return 1.5e-3 * std::sin(5 * t); };
  const Held alone = Drive(Compile(beside), 2, 5e-3, motion);
  for (const auto& [laminar, turbulent] : {std::pair{1e6, 0.0}, {3e7, 1e12}, {1e6, 1e11}}) {
    const PhsParams behind = With(beside, "line_resistance",
                                  {{"laminar_Pas_per_m3", laminar},
                                   {"turbulent_Pas2_per_m6", turbulent},
                                   {"oil_share", 0.4}});
    const Held at = Drive(Compile(behind), 2, 5e-3, motion);
    EXPECT_NEAR(at.p_rod / alone.p_rod, 1, 0.03) << laminar;
    EXPECT_NEAR(at.p_bore / alone.p_bore, 1, 0.03) << laminar;
    // Steps a tenth as long lead to the same: the scheme is of second order.
    const Held fine = Drive(Compile(behind), 2, 5e-4, motion);
    EXPECT_NEAR(at.p_rod / fine.p_rod, 1, 2e-3) << laminar;
  }
}

}  // namespace
}  // namespace phs::effects
