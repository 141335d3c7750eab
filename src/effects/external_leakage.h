// Oil lost from a line to the atmosphere, from a given time on: a leaking fitting, a burst hose.
//   dV_line/dt = -q,  q = G d,  d = p - p_a - p_o,  t >= start (it opens over 5 ms, pipe.h)
// p_o: a lip that lifts or a crack that gapes opens at a pressure over the atmosphere; 0: it is
// open at any. G [m3/(Pa s)]: weeping fitting 1e-15 … 1e-13, slow leak 1e-12, a lost line 1e-8 and
// more. Below atmospheric pressure an open line draws in what surrounds it. The static state is no
// longer steady: the precharge is lost with the time constant (V_oil/beta + V_g/p)/G. State: volume
// lost [m3]. At a place of the stroke alone, or as a film on the rod: leak_place.h.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& ExternalLeakageInfo();

}  // namespace phs::effects
