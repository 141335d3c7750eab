#include "hydraulics/gas_law.h"

#include <algorithm>
#include <cmath>

#include "hydraulics/bwr_nitrogen.h"

namespace phs::hydraulics {
namespace {

// Below this the laws are no longer meant; it keeps every expression finite.
constexpr double kColdest = 150.0;

double FreeVolume(const GasVolume& gas, double pressure, double T, double solved_volume,
                  double* dV_dp, double* dV_dT) {
  const double ratio = T / gas.reference_temperature;
  switch (gas.law) {
    case GasLaw::kIsothermal:
    case GasLaw::kIdeal: {
      const double volume = gas.reference_volume * gas.reference_pressure * ratio / pressure;
      *dV_dp = -volume / pressure;
      *dV_dT = volume / T;
      return volume;
    }
    case GasLaw::kPolytropic: {
      const double volume = gas.reference_volume * ratio *
                            std::pow(gas.reference_pressure / pressure, 1 / gas.exponent);
      *dV_dp = -volume / (gas.exponent * pressure);
      *dV_dT = volume / T;
      return volume;
    }
    case GasLaw::kBwr: {
      // A closed blow-off is the usual case: no need for the root.
      if (solved_volume <= 0 && pressure < CalcBwrPressure(gas.mass / gas.max_volume, T).p) {
        *dV_dp = *dV_dT = 0;
        return 2 * gas.max_volume;
      }
      const double rho = solved_volume > 0 ? gas.mass / solved_volume : CalcBwrDensity(pressure, T);
      const BwrPressure at = CalcBwrPressure(rho, T);
      const double volume = gas.mass / rho;
      *dV_dp = -volume / (rho * at.dp_drho);
      *dV_dT = volume * at.dp_dT / (rho * at.dp_drho);
      return volume;
    }
  }
  return 0;
}

}  // namespace

const std::vector<std::string>& GasLawNames() {
  static const std::vector<std::string> names = {"isothermal", "polytropic", "ideal", "bwr"};
  return names;
}

void GasVolume::SetMass() {
  const double rho = law == GasLaw::kBwr
                         ? CalcBwrDensity(reference_pressure, reference_temperature)
                         : reference_pressure / (kNitrogenR * reference_temperature);
  mass = rho * reference_volume;
}

GasState CalcGas(const GasVolume& gas, double pressure, double temperature, double solved_volume) {
  const double T = std::max(temperature, kColdest);
  GasState out;
  out.volume = FreeVolume(gas, pressure, T, solved_volume, &out.dV_dp, &out.dV_dT);
  if (out.volume < gas.min_volume || out.volume > gas.max_volume) {
    out.volume = std::clamp(out.volume, gas.min_volume, gas.max_volume);
    out.dV_dp = out.dV_dT = 0;
    out.stopped = true;
  }
  return out;
}

double CalcGasPressure(const GasVolume& gas, double volume, double temperature) {
  const double T = std::max(temperature, kColdest);
  const double p0V0 = gas.reference_pressure * gas.reference_volume;
  const double ratio = T / gas.reference_temperature;
  switch (gas.law) {
    case GasLaw::kIsothermal:
    case GasLaw::kIdeal:
      return p0V0 * ratio / volume;
    case GasLaw::kPolytropic:
      return gas.reference_pressure * std::pow(gas.reference_volume * ratio / volume, gas.exponent);
    case GasLaw::kBwr:
      return CalcBwrPressure(gas.mass / volume, T).p;
  }
  return 0;
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
  const double V0 = gas.reference_volume, T0 = gas.reference_temperature;
  const double p0V0 = gas.reference_pressure * V0;
  switch (gas.law) {
    case GasLaw::kIsothermal:
      return p0V0 * ambient / T0 * std::log(V0 / volume);
    case GasLaw::kPolytropic: {
      const double n1 = gas.exponent - 1, log_ratio = std::log(V0 / volume);
      const double work = std::abs(n1) < 1e-9 ? log_ratio : std::expm1(n1 * log_ratio) / n1;
      return p0V0 * std::pow(ambient / T0, gas.exponent) * work;
    }
    case GasLaw::kIdeal: {
      const double entropy = kNitrogenCv * std::log(T / T0) + kNitrogenR * std::log(volume / V0);
      return gas.mass * (kNitrogenCv * (T - T0) - ambient * entropy) +
             FillerExergy(gas, T, ambient);
    }
    case GasLaw::kBwr: {
      const double rho = gas.mass / volume, rho0 = gas.mass / V0;
      return gas.mass * (CalcBwrEnergy(rho, T) - CalcBwrEnergy(rho0, T0) -
                         ambient * (CalcBwrEntropy(rho, T) - CalcBwrEntropy(rho0, T0))) +
             FillerExergy(gas, T, ambient);
    }
  }
  return 0;
}

double CalcWallEnergy(const GasVolume& gas, double wall, double ambient) {
  return gas.HasWallState() ? HeatExergy(gas, WallHeat(gas), wall, ambient) : 0;
}

GasHeat CalcGasHeat(const GasVolume& gas, double volume, double temperature, double wall,
                    double ambient) {
  GasHeat out;
  if (!gas.HasTemperatureState()) return out;
  const double T = std::max(temperature, kColdest);
  double cv = kNitrogenCv, dp_dT = gas.mass * kNitrogenR / volume;
  if (gas.law == GasLaw::kBwr) {
    const double rho = gas.mass / volume;
    const BwrPressure at = CalcBwrPressure(rho, T);
    cv = CalcNitrogenCv0(T) + CalcBwrResidualCv(rho, T, at.decay);
    dp_dT = at.dp_dT;
  }
  cv += FillerHeat(gas);
  const double denser = gas.reference_volume / volume;
  out.time = gas.density_exponent == 0 ? gas.thermal_time
                                       : gas.thermal_time * std::pow(denser, -gas.density_exponent);
  out.relax = (wall - T) / out.time;
  out.kappa = T * dp_dT / (gas.mass * cv);
  out.loss = ambient * gas.mass * cv * (T - wall) * (T - wall) / (out.time * T * wall);
  if (!gas.HasWallState()) return out;
  out.wall_taken = gas.wall_heat_ratio * cv / kNitrogenCv / out.time;
  out.wall_rate = out.wall_taken * (T - wall) + (ambient - wall) / gas.wall_time;
  out.wall_slope = -out.wall_taken - 1 / gas.wall_time;
  out.loss += WallHeat(gas) * (wall - ambient) * (wall - ambient) / (gas.wall_time * wall);
  return out;
}

}  // namespace phs::hydraulics
