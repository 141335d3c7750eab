// The seals of some cylinders hold more or less than the others': level * factor, whatever the
// level is made of. The bristle stays. Dissipative for every factor >= 0.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SealFrictionInfo();

}  // namespace phs::effects
