// Limits of the energy equation: heat exchanged at once gives the isothermal gas, never exchanged
// the adiabatic one.
#include <gtest/gtest.h>

#include <cmath>

#include "hydraulics/bwr_gas.h"
#include "hydraulics/bwr_nitrogen.h"
#include "hydraulics/perfect_gas.h"
#include "test_systems.h"

namespace phs::hydraulics {
namespace {

// Rod pressure [Pa] after the piston has moved by 1.5 mm within 1 s and the gas has gone through
// it.
double RodPressure(const GasLaw* law, double thermal_time, double exponent) {
  PhsParams params = Quarter();
  params.friction.model = FrictionModel::kNone;
  for (LineParams& l : params.lines) {
    l.reservoir.law = law;
    l.reservoir.thermal_time_s = thermal_time;
    l.reservoir.polytropic_exponent = exponent;
  }
  const PhsSystem s = Make(params);
  std::vector<double> state(s.num_states(), 0.0), rate(state);
  const int n = 2000;
  const double h = 1.0 / n, v = 1.5e-3, still = 0;
  double x = 0;
  for (int i = 0; i < n; ++i) {
    s.CalcStateRate(i * h, h, &x, &v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
    x += h * v;
  }
  Evaluation e(s);
  s.Calc(1, &x, &still, state.data(), &e.out);
  return e.p_rod[0];
}

TEST(GasLimits, FastHeatIsIsothermal) {
  const double isothermal = RodPressure(&kIsothermalGas, 1, 1.4);
  EXPECT_NEAR(RodPressure(&kIdealGas, 1e-4, 1.4) / isothermal, 1, 1e-3);
  // The real gas at constant temperature: 0.3 % beside the ideal one up to 6 MPa.
  EXPECT_NEAR(RodPressure(&kBwrGas, 1e-4, 1.4) / isothermal, 1, 1e-2);
}

TEST(GasLimits, NoHeatIsAdiabatic) {
  const double gamma = 1 + kNitrogenR / kNitrogenCv;  // 1.3999
  const double adiabatic = RodPressure(&kPolytropicGas, 1, gamma);
  EXPECT_NEAR(RodPressure(&kIdealGas, 1e9, 1.4) / adiabatic, 1, 2e-3);
  EXPECT_NEAR(RodPressure(&kBwrGas, 1e9, 1.4) / adiabatic, 1, 5e-2);
  EXPECT_GT(adiabatic, 1.05 * RodPressure(&kIsothermalGas, 1, 1.4));
}

// Without heat the real gas keeps its entropy.
TEST(GasLimits, RealGasWithoutHeatKeepsItsEntropy) {
  GasVolume g;
  g.law = &kBwrGas;
  g.reference_volume = 16e-6;
  g.reference_pressure = 2e6;
  g.reference_temperature = 293.15;
  g.thermal_time = 1e12;
  g.max_volume = 1;
  g.SetMass();
  double T = 293.15;
  const int n = 20000;
  const double from = 16e-6, to = 4e-6, dV = (to - from) / n;
  for (int i = 0; i < n; ++i) {  // midpoint rule
    const double V = from + i * dV;
    const double half = T - CalcGasHeat(g, V, T, 293.15, 293.15).kappa * 0.5 * dV;
    T -= CalcGasHeat(g, V + 0.5 * dV, half, 293.15, 293.15).kappa * dV;
  }
  const double before = CalcBwrEntropy(g.mass / from, 293.15);
  EXPECT_GT(T, 450);
  EXPECT_NEAR(CalcBwrEntropy(g.mass / to, T) - before, 0, 1e-3);
}

}  // namespace
}  // namespace phs::hydraulics
