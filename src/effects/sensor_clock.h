// Channels of a card or logger with a clock of its own: shown(t) = true(t - r (t - t_0)), t_0 the
// first sample, r [-] by how much that clock runs too fast (crystals: up to 1e-4). What the channel
// shows comes ever later (r > 0) or ever earlier (r < 0); one that is always as late is sensor_delay.
// `all`: the actuator's motion is of another logger than every channel. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorClockInfo();

}  // namespace phs::effects
