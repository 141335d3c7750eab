// Mass that moves with a part on a bench, or with a cylinder on a rig behind its load cell: F = m
// a. One part or one cylinder only; on a vehicle masses belong to its bodies.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& MovingMassInfo();

}  // namespace phs::effects
