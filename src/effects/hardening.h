// Springs that harden as they are pressed: f(e) = 1 + b e², stored k e²/2 (1 + b e²/2).
#pragma once

#include "hydraulics/mount_law.h"

namespace phs::effects {

inline hydraulics::Stiffening Harden(double b, double e) {
  const double harder = b * e * e;
  return {.factor = 1 + harder, .slope = 1 + 3 * harder};
}

}  // namespace phs::effects
