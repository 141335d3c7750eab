// The gas law of nitrogen as a real gas:
//
//   bwr   p = p(T, v) of Benedict, Webb and Rubin (bwr_nitrogen.h),
//         dT/dt = (T_s - T)/tau - T (dp/dT)_v (dv/dt)/c_v(T, v)
#pragma once

#include "hydraulics/gas_law.h"

namespace phs::hydraulics {

extern const GasLaw kBwrGas;

}  // namespace phs::hydraulics
