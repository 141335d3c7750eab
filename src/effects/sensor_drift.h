// Error of the instruments that grows with time: shown = true + drift t. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorDriftInfo();

}  // namespace phs::effects
