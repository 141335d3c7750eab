// The reservoirs of some lines hold more or less gas than the model says: V_gas * factor, at the
// static pressure and temperature.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& GasVolumeInfo();

}  // namespace phs::effects
