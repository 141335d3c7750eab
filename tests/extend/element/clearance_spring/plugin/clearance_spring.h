// A spring with clearance between two sites, such as a bump stop or a worn pin: free near its
// length, then a spring to both sides.
//
//   e = l - l0,   F = -k (e - c) for e > c,  -k (e + c) for e < -c,  else 0
//
// E = k (|e| - c)²/2 beyond the clearance. Conservative.
#pragma once

#include <limits>

#include "plugin/line_elements.h"

namespace phs::plugin {

inline constexpr ElementKey kClearanceSpringKeys[] = {
    {"stiffness_N_per_m", 0, 1e12, std::numeric_limits<double>::quiet_NaN(), "k, beyond it"},
    {"length_m", 0, 100, std::numeric_limits<double>::quiet_NaN(), "l0, in the middle"},
    {"clearance_m", 0, 10, 0, "c, free way to each side"},
};

Result<std::unique_ptr<const Elements>> FindClearanceSprings(const mjModel* m,
                                                             const ElementKind& kind);

}  // namespace phs::plugin
