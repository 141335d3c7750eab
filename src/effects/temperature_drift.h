// Surroundings and oil get warmer or colder during the run:
//   T(t) = T_static + min(|r t|, limit) sgn(r) + A sin(2 pi t/period) + B (cos(2 pi t/period) - 1),
// or r T_s (1 - exp(-t/T_s)) for r t where the warming settles: dT/dt = r - (T - T_static)/T_s, a
// source of heat against what goes to the surroundings (Newton's law of cooling). Where the source
// ends at stop_s, r = 0 from there on: the same T_s takes the warmth away again.
// Gas pressures follow T; the oil expands against its housing by `expansion` [1/K] (mineral oil
// 7e-4 less steel 3.5e-5), that of rod lines by rod_ratio times as much (they may warm more, or
// hold more oil than their stiffness tells). A line without gas rises by beta * 6.7e-4 = 0.9 MPa
// per kelvin. The bulk modulus falls to beta exp(-s (T - T_static)), s [1/K] 0 … 0.01 (mineral oil
// about 0.004). r [K/s] up to 0.05, A [K] up to 30. Gives energy from outside: not passive.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& TemperatureDriftInfo();

}  // namespace phs::effects
