// Friction that falls as it gets warmer: the whole level (not the viscous force) times
//   max(1 - slope (T - T_static), 0) exp(-w h) max(1 + a exp(-t/t_w), 0),   dh/dt = |v| - h/t_c.
// T: the measured temperature on a bench, else the surroundings (effect temperature_drift). slope >
// 0: warm grease or rubber rubs less. h [m]: the way slid whose heat is still in the seal; its
// friction power is about level times |v|, and w [1/m] the share of the friction that a metre of
// sliding takes. It loses the heat with the time constant t_c (Newton's law of cooling): a lip of
// rubber, 0.5 mm and 1e-7 m2/s, in some 2 s, a gland in minutes. w < 0: a ring that swells as it
// gets warm. a, t_w: a rig that was cold when the record began. Dissipative: the level stays >= 0.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& TemperatureFrictionInfo();

}  // namespace phs::effects
