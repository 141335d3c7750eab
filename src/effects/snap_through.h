// A wall of a line that snaps over: the dome of a blanking disc, a cover plate with a slack bolt, a
// buckled diaphragm. It goes outward once the line's pressure is above p_c + P_s and comes back
// below p_c - P_s; while it stands out it takes V from the line:
//   W_0 = V/2 tanh((p - p_c + P_s u)/P),   tau dW/dt = W_0 - W,   u = 2W/V        (snap_flow.h)
// V [m3], p_c [Pa] absolute, P_s [Pa] half between the two pressures, P [Pa] how much it gives at
// either shape (P << P_s: it snaps), tau [s] of the snap. At first it stands as the static pressure
// says. There and back it loses 2 P_s V, where the line is soft enough that its pressure stays.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& SnapThroughInfo();

}  // namespace phs::effects
