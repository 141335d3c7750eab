// The gas laws of a perfect gas:
//
//   isothermal   p V = p0 V0 T_s/T0                 T = T_s
//   polytropic   p V^n = p0 V0^n (T_s/T0)^n
//   ideal        p V = m R T,   dT/dt = (T_s - T)/tau - p (dV/dt)/(m c_v0)
#pragma once

#include "hydraulics/gas_law.h"

namespace phs::hydraulics {

extern const GasLaw kPolytropicGas;
extern const GasLaw kIdealGas;

}  // namespace phs::hydraulics
