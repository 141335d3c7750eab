// Instruments that show one way up and another way down, however slowly.
//   shown = true - a z,   z: mean of elements that each follow the true value until they slip, at
//   W/n, 2 W/n … W (Prandtl and Ishlinskii, evenly spread), and lose what they hold with T
// A load cell whose joints slip a little, or beside which a bolted part carries a share (OIML R 60,
// ISO 376: hysteresis error): a is that share for small swings, W [N] the swing at which all of it
// slips; a cell of class C has a loop of some 1e-4 of its range. A gauge whose membrane rubs on
// its seat is the same, W [Pa]; one behind a plug of grease shows nothing until W moves the plug:
// a = 1, and T [s] is how it seeps. a >= 0: the loop takes up, it gives nothing out.
// Rate-independent but for T. Nothing is held at the first sample. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorHysteresisInfo();

}  // namespace phs::effects
