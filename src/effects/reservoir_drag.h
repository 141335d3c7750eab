// The gas of a reservoir stands behind something that drags: a separating piston, a braid that
// grips, a narrow neck. The line's pressure is above the gas's while oil goes in, below while it
// comes out:
//   p_line - p_gas = P_f sign(q) + R q + K q|q|
// P_f [Pa] friction over area (a piston with an O-ring in a bore of 50 mm, 100 N: 5e4), R [Pa s/m3]
// of the neck at 20 °C, as 1/viscosity (a bore of 3 mm, 50 mm long: 2e9), K [Pa s2/m6] of its edge
// (rho/(2 A²), a hole of 3 mm: 1e13). Within P_f the gas is shut in and the oil alone yields. The
// blow-off stays at the line; 1 % of the oil is with the gas.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& ReservoirDragInfo();

}  // namespace phs::effects
