// Level depends on where the piston is (worn middle, out of round): times 1 + s y + c y², kept >=
// 0. s [1/m] -50 … 50, c [1/m2] -1e5 … 1e5; y piston displacement. Dissipative.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& PositionFrictionInfo();

}  // namespace phs::effects
