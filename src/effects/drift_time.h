// Time that counts for what drifts, of instruments and of the temperature.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::effects {

/// What du/dt = [start < t < stop] - u/T holds at `time`, T = `settling`: 0 before `start`, then
/// T (1 - exp(-(t - start)/T)), and beyond `stop` what is left of it, exp(-(t - stop)/T). `settling`
/// 0: T has no end, so t - start, and u stays from `stop` on. `start` 0: from the beginning of the
/// record on, and t itself where that is negative. All in s.
inline double DriftTime(double time, double start, double settling,
                        double stop = std::numeric_limits<double>::infinity()) {
  const double until = std::min(time, stop);
  const double since = start == 0 ? until : std::max(0.0, until - start);
  if (!(settling > 0)) return since;
  return -settling * std::expm1(-since / settling) * std::exp(-(time - until) / settling);
}

}  // namespace phs::effects
