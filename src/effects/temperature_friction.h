// Friction that falls as it gets warmer: the whole level (not the viscous force) times
// 1 - slope (T - T_static), kept >= 0. T: the measured temperature on a bench, else the
// surroundings (effect temperature_drift). slope > 0: warm grease or rubber rubs less.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& TemperatureFrictionInfo();

}  // namespace phs::effects
