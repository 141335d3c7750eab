// Friction beside the declared curve turns over a speed of its own: times v / sqrt(v² + v_t²).
// v_t [m/s]: where it is 0.71 of its full size; 0: at once. A dry lip turns over some µm/s, one
// that a film lifts or that has to roll over some mm/s; the declared curve, measured without it,
// says nothing of that. Dissipative: it keeps the sign of the level.
#pragma once

#include <cmath>

#include "hydraulics/extension.h"

namespace phs::effects {

inline const hydraulics::EffectParameter kTurn = {
    "turn_m_s", "m/s", 0,    0,
    10,         0,     0.02, "v_t: it grows with v/sqrt(v^2 + v_t^2); 0: full at once"};

inline hydraulics::FormOption TurnOption() { return {.free = {{"turn_m_s", 3e-4, 3e-3, 2}}}; }

/// Share of the full size at a speed >= 0 [m/s].
inline double Turned(double speed, double turn_m_s) {
  if (turn_m_s == 0) return 1;
  return speed / std::sqrt(speed * speed + turn_m_s * turn_m_s);
}

}  // namespace phs::effects
