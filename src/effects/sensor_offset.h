// Constant error of the instruments: shown = true + offset. Changes predicted channels of a rig
// only, no force. Units in the keys.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorOffsetInfo();

}  // namespace phs::effects
