// Instruments show what was a while ago: shown(t) = true(t - delay), delay [s] 0 … 0.2, by channel.
// Or a filter was left in the channel: `poles` lags of first order one behind the other,
// T y' = u - y, T = delay/poles each, so that slow signals come late by the delay; of 2.3 of them, a
// mean of the filters with 2 and 3. Or the channel rings, as a gauge on a tube with a bubble or a
// load cell with a mass on it: T² y'' + 2 D T y' + y = u, T = 1/(2 pi f) [s] of its frequency f,
// D = `damping` below 1; slow signals come late by 2 D T. A bubble is a spring that stiffens with
// the pressure: T = T(2 MPa) (y/2 MPa)^-n, n = `bubble` (1: it is the only spring, and isothermal).
// A frame of which a load cell feels one mode only in part shows u + share (y - u); below 0 where
// the cell and the mode's mass lie on opposite sides of a node.
// Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorDelayInfo();

}  // namespace phs::effects
