// Time that counts for what drifts, of instruments and of the temperature.
#pragma once

#include <algorithm>
#include <cmath>

namespace phs::effects {

/// 0 before `start`, then t - start; `start` 0: t, also where it is negative. For a drift that
/// settles T (1 - exp(-(t - start)/T)) with T = `settling` > 0. All in s.
inline double DriftTime(double time, double start, double settling) {
  const double since = start == 0 ? time : std::max(0.0, time - start);
  return settling > 0 ? -settling * std::expm1(-since / settling) : since;
}

}  // namespace phs::effects
