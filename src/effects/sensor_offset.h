// Constant error of the instruments: shown = true + offset. With a start t_s the offset comes in
// the record (a knock, an overload, a plug pushed home), within about w:
//   offset (1 + tanh(2 (t - t_s)/w))/2;   w = 0: at once.
// Changes predicted channels of a rig only, no force. Units in the keys.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorOffsetInfo();

}  // namespace phs::effects
