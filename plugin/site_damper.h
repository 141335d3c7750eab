// A hydraulic damper between two sites, such as a yaw damper between frame and car body.
//
//   |F| = c |v|                      up to the relief force F_r
//   |F| = F_r + c_r (|v| - F_r/c)    beyond, where the valve blows off; against the motion
//
// Linear with c without a relief force. Mounts and the oil's own stiffness are not in it: where
// they count, put a spring in series between bodies (EN 13802:2013 calls the pair dynamic
// stiffness).
#pragma once

#include <limits>

#include "plugin/line_elements.h"

namespace phs::plugin {

struct SiteDamperParams {
  double damping = 0;         ///< c [N s/m]
  double relief = 0;          ///< F_r [N]
  double relief_damping = 0;  ///< c_r [N s/m], <= c
};

/// Force at a rate of length [m/s].
DamperForce CalcSiteDamper(const SiteDamperParams& p, double speed);

inline constexpr double kNoRelief = 1e9;  ///< [N]
inline constexpr ElementKey kSiteDamperKeys[] = {
    {"damping_Ns_per_m", 0, 1e9, std::numeric_limits<double>::quiet_NaN(),
     "up to the relief force"},
    {"relief_N", 1, kNoRelief, kNoRelief, "force at which the valve blows off; without it never"},
    {"relief_damping_Ns_per_m", 0, 1e9, 0, "beyond it; at most damping_Ns_per_m"},
};

Result<std::unique_ptr<const Elements>> FindSiteDampers(const mjModel* m, const ElementKind& kind);

}  // namespace phs::plugin
