// A strap or chain between two sites: pulls beyond its length, else hangs loose.
//
//   F = -k (l - l0) for l > l0, else 0;   E = k (l - l0)²/2;   damping c beyond l0, never pushing:
//   F_d = -c v, at most as much as F pulls
#pragma once

#include <limits>

#include "plugin/line_elements.h"

namespace phs::plugin {

inline constexpr ElementKey kStrapKeys[] = {
    {"stiffness_N_per_m", 0, 1e12, std::numeric_limits<double>::quiet_NaN(), "k, taut"},
    {"length_m", 0, 100, std::numeric_limits<double>::quiet_NaN(), "l0, where it becomes taut"},
    {"damping_Ns_per_m", 0, 1e9, 0, "c, taut"},
};

Result<std::unique_ptr<const Elements>> FindStraps(const mjModel* m, const ElementKind& kind);

}  // namespace phs::plugin
