// An amplifier whose range the signal leaves: shown = true / (1 + (|true|/L)^n)^(1/n), L the end of
// the range [unit of the channel], to either side of zero (C. Rapp, Effects of HPA-nonlinearity on a
// 4-DPSK/OFDM-signal for a digital sound broadcasting system, 1991, his 2p = n). Small signals come
// through unharmed; n large: up to L, then L alone (a converter that clips), which the data checks
// leave out where nothing is added behind it. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorSaturationInfo();

}  // namespace phs::effects
