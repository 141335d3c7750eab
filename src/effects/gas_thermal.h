// The gas warms as it is compressed and gives its heat to the surroundings with a time constant
// tau: gas law `ideal` with energy equation (hydraulics/gas_law.h) for reservoir and accumulator,
//   dT/dt = (T_s - T)/tau - p (dV/dt)/(m c_v),
// or `bwr` (real gas). Fast: adiabatic; slow: isothermal. tau [s] 0.3 … 30 (Otis and Pourmovahed
// 1985; thesis Table B-1). State: temperature deviation [K]. Loss: exergy destroyed by the heat
// flow.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& GasThermalInfo();

}  // namespace phs::effects
