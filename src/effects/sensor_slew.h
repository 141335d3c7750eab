// An amplifier or converter that cannot follow faster than a rate R [unit of the channel per s]:
//   |d(shown)/dt| <= R, towards the true value; the true value itself once it is reached
// or, of a stage that runs into its limit little by little (an operational amplifier's pair of
// transistors: J. E. Solomon, IEEE J. Solid-State Circuits 9 (1974) 314), with a time tau
//   d(shown)/dt = R tanh((true - shown)/(R tau))
// which is a lag of first order for small signals. Slow signals come through unharmed, however
// large; one that is late for all of them is sensor_delay. Where nothing is faster than R nobody
// sees it. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorSlewInfo();

}  // namespace phs::effects
