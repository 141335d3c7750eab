#include "hydraulics/gas_law.h"

#include <algorithm>
#include <cmath>

namespace phs::hydraulics {
namespace {

// Below this the laws are no longer meant; it keeps every expression finite.
constexpr double kColdest = 150.0;

}  // namespace

void GasVolume::SetMass() {
  mass = law->density(reference_pressure, reference_temperature) * reference_volume;
}

GasState CalcGas(const GasVolume& gas, double pressure, double temperature, double solved_volume) {
  const double T = std::max(temperature, kColdest);
  GasState out = gas.law->volume(gas, pressure, T, solved_volume);
  if (out.volume < gas.min_volume || out.volume > gas.max_volume) {
    out.volume = std::clamp(out.volume, gas.min_volume, gas.max_volume);
    out.dV_dp = out.dV_dT = 0;
    out.stopped = true;
  }
  return out;
}

double CalcGasPressure(const GasVolume& gas, double volume, double temperature) {
  return gas.law->pressure(gas, volume, std::max(temperature, kColdest));
}

namespace {

/// Heat capacity of the filler per mass of gas [J/(kg K)].
double FillerHeat(const GasVolume& gas) { return (gas.heat_capacity_ratio - 1) * kNitrogenCv; }

/// Heat capacity of the wall [J/K].
double WallHeat(const GasVolume& gas) { return gas.mass * kNitrogenCv / gas.wall_heat_ratio; }

/// Of a body of heat capacity C that neither takes nor gives volume.
double HeatExergy(const GasVolume& gas, double C, double T, double ambient) {
  const double T0 = gas.reference_temperature;
  return C * (T - T0 - ambient * std::log(T / T0));
}

double FillerExergy(const GasVolume& gas, double T, double ambient) {
  return HeatExergy(gas, gas.mass * FillerHeat(gas), T, ambient);
}

}  // namespace

double CalcGasEnergy(const GasVolume& gas, double volume, double temperature, double ambient) {
  const double T = std::max(temperature, kColdest);
  const double energy = gas.law->energy(gas, volume, T, ambient);
  return gas.HasTemperatureState() ? energy + FillerExergy(gas, T, ambient) : energy;
}

double CalcWallEnergy(const GasVolume& gas, double wall, double ambient) {
  return gas.HasWallState() ? HeatExergy(gas, WallHeat(gas), wall, ambient) : 0;
}

GasHeat CalcGasHeat(const GasVolume& gas, double volume, double temperature, double wall,
                    double ambient) {
  GasHeat out;
  if (!gas.HasTemperatureState()) return out;
  const double T = std::max(temperature, kColdest);
  const GasCapacity at = gas.law->capacity(gas, volume, T);
  const double cv = at.cv + FillerHeat(gas);
  const double denser = gas.reference_volume / volume;
  out.time = gas.density_exponent == 0 ? gas.thermal_time
                                       : gas.thermal_time * std::pow(denser, -gas.density_exponent);
  out.relax = (wall - T) / out.time;
  out.kappa = T * at.dp_dT / (gas.mass * cv);
  out.loss = ambient * gas.mass * cv * (T - wall) * (T - wall) / (out.time * T * wall);
  if (!gas.HasWallState()) return out;
  out.wall_taken = gas.wall_heat_ratio * cv / kNitrogenCv / out.time;
  out.wall_rate = out.wall_taken * (T - wall) + (ambient - wall) / gas.wall_time;
  out.wall_slope = -out.wall_taken - 1 / gas.wall_time;
  out.loss += WallHeat(gas) * (wall - ambient) * (wall - ambient) / (gas.wall_time * wall);
  return out;
}

}  // namespace phs::hydraulics
