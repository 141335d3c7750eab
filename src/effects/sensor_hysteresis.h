// A load cell whose reading goes one way up and another way down, however slowly: its joints slip a
// little, or a bolted part beside it carries a share (OIML R 60, ISO 376: hysteresis error).
//   shown = true - a z,   z: mean of elements that each follow the force until they slip, at
//   W/n, 2 W/n … W (Prandtl and Ishlinskii, evenly spread)
// a [-]: share of the force beside the cell for small swings; W [N]: swing at which all of it
// slips. A cell of class C has a loop of some 1e-4 of its range. Rate-independent. Nothing is held
// at the first sample. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorHysteresisInfo();

}  // namespace phs::effects
