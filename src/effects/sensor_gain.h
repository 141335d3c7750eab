// Instruments with a wrong scale: shown = gain * true, gain [-] by channel, plausible 0.4 … 2.5.
// Load cells are calibrated in tension and in compression apart (ISO 376), so one may have another
// gain in compression (force < 0): load_compression [-] times as much; so may a sensor of the piston
// whose two halves (an LVDT's coils) are not alike: piston_retraction, where x < 0.
// A pressure gauge that was set right at the static pressure is wrong about it: shown = p0 + gain
// (p - p0) (zeroed_at_rest); one whose membrane meets something is right up to a pressure and shows
// gain times what comes on top (from_Pa, which goes before zeroed_at_rest). Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorGainInfo();

}  // namespace phs::effects
