// An amplifier or converter that cannot follow faster than a rate R:
//   d(shown)/dt = (true - shown) held to [-R, R], at once where that allows
// R [unit of the channel per s] is half to a tenth of what the channel does, or nobody sees it.
// Slow signals come through unharmed, however large; a delay of all of them is sensor_delay.
// Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorSlewInfo();

}  // namespace phs::effects
