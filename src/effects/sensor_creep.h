// Instruments of which a share of the signal comes late and fades late: the foil and the glue of a
// strain gauge creep under load and return after it (OIML R 60: creep and its recovery).
//   shown = true + a [(1 - b) z1 + b z2],   tau_i dz_i/dt = (true - at first) - z_i
// a [-] by channel, load cells 2e-4 … 0.1, of either sign; b: the part that is slow. Or over
// decades of time: with `spread` d > 1 a third of the quick part each has tau/d, tau, tau d. At the
// first sample the gauge has settled. So it is right at first. One that was calibrated by weights
// that lay still (`settled`) is right in the end: a [u - (1 - b) z1 - b z2] is missing, u = true -
// at first. Predicted channels only.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SensorCreepInfo();

}  // namespace phs::effects
