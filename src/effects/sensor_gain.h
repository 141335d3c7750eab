// Instruments with a wrong scale: shown = gain * true, gain [-] 0.8 … 1.2 by channel. Predicted
// channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorGainInfo();

}  // namespace phs::effects
