// A friction strut between two sites, such as a wedge or a leaf spring's rubbing: a force against
// the motion that hardly depends on its speed.
//
//   F = -F0 tanh(v/v0)    F0 level [N], v0 speed over which it turns [m/s]
//
// Lost power -F v >= 0. It creeps where it should stick: with v0 = 1 mm/s by 1 mm/s at 3/4 F0.
#pragma once

#include <limits>

#include "plugin/line_elements.h"

namespace phs::plugin {

inline constexpr ElementKey kFrictionStrutKeys[] = {
    {"level_N", 0, 1e7, std::numeric_limits<double>::quiet_NaN(), "F0"},
    {"turn_m_s", 1e-6, 1, 1e-3, "v0, speed over which the force turns"},
};

Result<std::unique_ptr<const Elements>> FindFrictionStruts(const mjModel* m,
                                                           const ElementKind& kind);

}  // namespace phs::plugin
