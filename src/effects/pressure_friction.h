// Seals are pressed on by the oil: level + k_bore (p_bore - p_bore0) + k_rod (p_rod - p_rod0), kept
// >= 0. k [N/Pa] = mu pi D l of the seal lip: 0 … 5e-4 for a 100 mm cylinder (1e-4: 100 N per MPa).
// A lip that bears only when the oil presses it out begins at a pressure p_s: of p and p0 counts
// what is above (start_Pa, absolute). One that is soon flat, or bears ever more, grows with
// p (p/10 MPa)^(n-1) (exponent). One that is pressed flat grips no more: p/(1 + p/p_f) in the place
// of p (flat_Pa; the area in true contact cannot outgrow the lip: Persson 2001, J. Chem. Phys. 115,
// 3840). A lip that turns over with the motion is gripped by another share
// in retraction (retraction_ratio). What is added turns over a speed of its own (added_friction.h).
// Friction is a coefficient that knows the speed times what presses the lip, so oil may also press
// the whole curve: level (1 + a_bore (p_bore - p_bore0) + a_rod (p_rod - p_rod0)), a [1/Pa]
// (bore_1_per_Pa, rod_1_per_Pa; 1e-7: doubled by 10 MPa), bent likewise. A ring that sits on the side
// of the lower pressure is pressed by the larger of the two: level (1 + a_l (max(p_bore, p_rod) - at
// rest)) (larger_1_per_Pa).
// On a bench p is the pressure channel and p0 = 0. Dissipative: part of the friction level.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& PressureFrictionInfo();

}  // namespace phs::effects
