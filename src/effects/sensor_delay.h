// Instruments show what was a while ago: shown(t) = true(t - delay). delay [s] 0 … 0.2, by channel.
// Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorDelayInfo();

}  // namespace phs::effects
