// Force of the end stops of a cylinder: EndStopParams in phs_params.h gives the law.
#pragma once

#include <algorithm>
#include <cmath>

#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

struct EndStopForce {
  double force = 0;       ///< tension > 0: resists over-extension [N]
  double energy = 0;      ///< [J]
  double lost_power = 0;  ///< [W] >= 0
  double slope = 0;       ///< d(force)/dy of the elastic part [N/m]
  double damper = 0;      ///< d(force)/dv [N s/m]
};

inline EndStopForce CalcEndStop(const EndStopParams& p, double y, double v) {
  EndStopForce out;
  const double s = std::abs(y) - p.clearance_m;
  if (s <= 0) return out;
  const double side = y > 0 ? 1 : -1, d = p.transition_m, k = p.stiffness_N_per_m;
  const double soft = std::min(s, d), hard = s - soft;
  const double elastic = k * (soft * soft / (2 * d) + hard);
  out.slope = k * soft / d;
  out.energy = k * (soft * soft * soft / (6 * d) + hard * (d / 2 + hard / 2));
  // The stop pushes only: damping may at most cancel the elastic force on the way out.
  const double damping = std::max(p.damping_Ns_per_m * soft / d * side * v, -elastic);
  if (damping > -elastic) out.damper = p.damping_Ns_per_m * soft / d;
  out.force = side * (elastic + damping);
  out.lost_power = damping * side * v;
  return out;
}

}  // namespace phs::hydraulics
