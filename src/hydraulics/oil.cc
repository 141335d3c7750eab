#include "hydraulics/oil.h"

#include <algorithm>
#include <cmath>

#include "hydraulics/gas_law.h"

namespace phs::hydraulics {
namespace {

constexpr double kColdestOil = 253.15, kWarmestOil = 373.15;

double DoubleLog(double nu_mm2_s) { return std::log10(std::log10(nu_mm2_s + 0.7)); }

}  // namespace

double CalcKinematicViscosity(double temperature_K, const OilParams& oil) {
  const double T = std::clamp(temperature_K, kColdestOil, kWarmestOil);
  const double x40 = std::log10(313.15), x100 = std::log10(373.15);
  const double y40 = DoubleLog(oil.viscosity_40C_mm2_s), y100 = DoubleLog(oil.viscosity_100C_mm2_s);
  const double y = y40 + (y100 - y40) * (std::log10(T) - x40) / (x100 - x40);
  return (std::pow(10.0, std::pow(10.0, y)) - 0.7) * 1e-6;
}

double CalcDensity(double temperature_K, const OilParams& oil) {
  const double T = std::clamp(temperature_K, kColdestOil, kWarmestOil);
  return oil.density_15C_kg_m3 / (1 + oil.expansion_1_per_K * (T - 288.15));
}

double CalcDynamicViscosity(double temperature_K, const OilParams& oil) {
  return CalcKinematicViscosity(temperature_K, oil) * CalcDensity(temperature_K, oil);
}

double CalcViscosityRatio(double temperature_K, const OilParams& oil) {
  constexpr double k20C_K = 293.15;
  if (temperature_K == k20C_K) return 1;
  return CalcDynamicViscosity(temperature_K, oil) / CalcDynamicViscosity(k20C_K, oil);
}

double CalcEffectiveBulkModulus(double pressure, double bulk_modulus, double air_fraction,
                                double polytropic_exponent) {
  const double n = polytropic_exponent;
  const double air = air_fraction * std::pow(kAtmosphere / pressure, 1 / n);
  return (1 + air) / (1 / bulk_modulus + air / (n * pressure));
}

}  // namespace phs::hydraulics
