// The gas warms as it is compressed and gives its heat to the surroundings with a time constant
// tau: gas law `ideal` with energy equation (hydraulics/gas_law.h) for reservoir and accumulator,
//   dT/dt = (T_s - T)/tau - p (dV/dt)/(m c_v),
// or `bwr` (real gas). Fast: adiabatic; slow: isothermal. tau [s] 0.3 … 30 (Otis and Pourmovahed
// 1985; thesis Table B-1), less in small vessels. Heat may also be stored by a filler at the gas's
// temperature (heat_capacity_ratio; below 1 a gas of fewer degrees of freedom than nitrogen, 0.6
// for one of single atoms: 1 + R/(0.6 c_v) = 5/3) and by a wall between gas and surroundings
// (wall_heat_ratio r, wall_time_s: gas_law.h); tau may fall with density (density_exponent:
// convection). Blow-off accumulators may have another tau (accumulator_ratio). States: deviations
// of gas and wall temperature [K]. Loss: exergy destroyed by the heat flows.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& GasThermalInfo();

}  // namespace phs::effects
