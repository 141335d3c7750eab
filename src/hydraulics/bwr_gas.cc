#include "hydraulics/bwr_gas.h"

#include "hydraulics/bwr_nitrogen.h"

namespace phs::hydraulics {
namespace {

double CalcRealDensity(double pressure, double T) { return CalcBwrDensity(pressure, T); }

GasState CalcVolume(const GasVolume& gas, double pressure, double T, double solved_volume) {
  // A closed blow-off is the usual case: no need for the root.
  if (solved_volume <= 0 && pressure < CalcBwrPressure(gas.mass / gas.max_volume, T).p) {
    return {2 * gas.max_volume};
  }
  const double rho = solved_volume > 0 ? gas.mass / solved_volume : CalcBwrDensity(pressure, T);
  const BwrPressure at = CalcBwrPressure(rho, T);
  const double volume = gas.mass / rho;
  return {volume, -volume / (rho * at.dp_drho), volume * at.dp_dT / (rho * at.dp_drho)};
}

double CalcPressure(const GasVolume& gas, double volume, double T) {
  return CalcBwrPressure(gas.mass / volume, T).p;
}

double CalcEnergy(const GasVolume& gas, double volume, double T, double ambient) {
  const double T0 = gas.reference_temperature;
  const double rho = gas.mass / volume, rho0 = gas.mass / gas.reference_volume;
  return gas.mass * (CalcBwrEnergy(rho, T) - CalcBwrEnergy(rho0, T0) -
                     ambient * (CalcBwrEntropy(rho, T) - CalcBwrEntropy(rho0, T0)));
}

GasCapacity CalcCapacity(const GasVolume& gas, double volume, double T) {
  const double rho = gas.mass / volume;
  const BwrPressure at = CalcBwrPressure(rho, T);
  return {CalcNitrogenCv0(T) + CalcBwrResidualCv(rho, T, at.decay), at.dp_dT};
}

GasPressure CalcOfDensity(double density, double T) {
  const BwrPressure at = CalcBwrPressure(density, T);
  return {at.p, at.dp_drho};
}

}  // namespace

const GasLaw kBwrGas = {.name = "bwr",
                        .text = "real gas after Benedict, Webb and Rubin with an energy equation",
                        .follows_boyle = false,
                        .density = CalcRealDensity,
                        .volume = CalcVolume,
                        .pressure = CalcPressure,
                        .energy = CalcEnergy,
                        .capacity = CalcCapacity,
                        .of_density = CalcOfDensity};

}  // namespace phs::hydraulics
