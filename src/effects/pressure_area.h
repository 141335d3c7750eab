// Pressure on an unbalanced area of a part on a bench: F = A p. Element rig only; the areas of a
// cylinder are its bore_m and rod_m. Sign: A > 0, pressure pushes in the sense of tension.
// p: the bench's pressure channel [Pa].
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& PressureAreaInfo();

}  // namespace phs::effects
