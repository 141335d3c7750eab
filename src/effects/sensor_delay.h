// Instruments show what was a while ago: shown(t) = true(t - delay), delay [s] 0 … 0.2, by channel.
// Or a filter was left in the channel: `poles` lags of first order one behind the other,
// T y' = u - y, T = delay/poles each, so that slow signals come late by the delay; of 2.3 of them, a
// mean of the filters with 2 and 3. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorDelayInfo();

}  // namespace phs::effects
