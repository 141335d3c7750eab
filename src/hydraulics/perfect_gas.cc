#include "hydraulics/perfect_gas.h"

#include <cmath>

namespace phs::hydraulics {
namespace {

double CalcPerfectDensity(double pressure, double T) { return pressure / (kNitrogenR * T); }

GasState CalcBoyleVolume(const GasVolume& gas, double pressure, double T, double) {
  const double ratio = T / gas.reference_temperature;
  const double volume = gas.reference_volume * gas.reference_pressure * ratio / pressure;
  return {volume, -volume / pressure, volume / T};
}

double CalcBoylePressure(const GasVolume& gas, double volume, double T) {
  const double p0V0 = gas.reference_pressure * gas.reference_volume;
  return p0V0 * (T / gas.reference_temperature) / volume;
}

double CalcIsothermalEnergy(const GasVolume& gas, double volume, double, double ambient) {
  const double p0V0 = gas.reference_pressure * gas.reference_volume;
  return p0V0 * ambient / gas.reference_temperature * std::log(gas.reference_volume / volume);
}

GasState CalcPolytropicVolume(const GasVolume& gas, double pressure, double T, double) {
  const double ratio = T / gas.reference_temperature;
  const double volume =
      gas.reference_volume * ratio * std::pow(gas.reference_pressure / pressure, 1 / gas.exponent);
  return {volume, -volume / (gas.exponent * pressure), volume / T};
}

double CalcPolytropicPressure(const GasVolume& gas, double volume, double T) {
  const double ratio = T / gas.reference_temperature;
  return gas.reference_pressure * std::pow(gas.reference_volume * ratio / volume, gas.exponent);
}

double CalcPolytropicEnergy(const GasVolume& gas, double volume, double, double ambient) {
  const double p0V0 = gas.reference_pressure * gas.reference_volume;
  const double n1 = gas.exponent - 1, log_ratio = std::log(gas.reference_volume / volume);
  const double work = std::abs(n1) < 1e-9 ? log_ratio : std::expm1(n1 * log_ratio) / n1;
  return p0V0 * std::pow(ambient / gas.reference_temperature, gas.exponent) * work;
}

double CalcIdealEnergy(const GasVolume& gas, double volume, double T, double ambient) {
  const double T0 = gas.reference_temperature;
  const double entropy =
      kNitrogenCv * std::log(T / T0) + kNitrogenR * std::log(volume / gas.reference_volume);
  return gas.mass * (kNitrogenCv * (T - T0) - ambient * entropy);
}

GasCapacity CalcIdealCapacity(const GasVolume& gas, double volume, double) {
  return {kNitrogenCv, gas.mass * kNitrogenR / volume};
}

}  // namespace

const GasLaw kIsothermalGas = {.name = "isothermal",
                               .text = "perfect gas at the temperature of the surroundings",
                               .follows_boyle = true,
                               .density = CalcPerfectDensity,
                               .volume = CalcBoyleVolume,
                               .pressure = CalcBoylePressure,
                               .energy = CalcIsothermalEnergy};

const GasLaw kPolytropicGas = {.name = "polytropic",
                               .text = "perfect gas with a fixed exponent",
                               .follows_boyle = false,
                               .density = CalcPerfectDensity,
                               .volume = CalcPolytropicVolume,
                               .pressure = CalcPolytropicPressure,
                               .energy = CalcPolytropicEnergy};

const GasLaw kIdealGas = {.name = "ideal",
                          .text = "perfect gas with an energy equation",
                          .follows_boyle = true,
                          .density = CalcPerfectDensity,
                          .volume = CalcBoyleVolume,
                          .pressure = CalcBoylePressure,
                          .energy = CalcIdealEnergy,
                          .capacity = CalcIdealCapacity};

}  // namespace phs::hydraulics
