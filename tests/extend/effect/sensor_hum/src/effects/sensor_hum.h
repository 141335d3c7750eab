// Mains hum on a measuring chain: shown = true + A sin(2 pi f t), on the load cell and both
// pressures. Instrument only: nothing of the motion changes.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorHumInfo();

}  // namespace phs::effects
