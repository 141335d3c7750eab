// The gas of a reservoir goes, through a valve core that leaks, a pinhole, or through the diaphragm
// into the oil and away: of what was there at the start the share m has gone,
//   dm/dt = r ((p - p_s)/p0)^k,  p > p_s,  until nothing is left,
// and the line lacks m V_g0 p0/p of gas, which oil fills (isothermal, however the rest is warmed).
// r [1/s]: share that goes each second at the static pressure p0 (k = 1, p_s = 0: choked flow and
// permeation go with the pressure; k = 0: a steady loss). A valve that weeps loses 1e-7, a hole of
// 0.05 mm in 16 ml at 2 MPa 2e-2. The precharge is lost with it, as by an external leak, but the
// line grows stiffer. A stop of the diaphragm is not moved. State: m. Loss: what gas at p could do
// against the atmosphere.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& GasLossInfo();

}  // namespace phs::effects
