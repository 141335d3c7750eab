#include "rail/carter.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {

double CalcCarter(double xi, double relative_radius, double half_width, double friction) {
  const double stick = 1 - std::abs(xi) * relative_radius / (friction * half_width);
  const double part = std::max(stick, 0.0);
  return std::copysign(1 - part * part, -xi);
}

double CalcCarterStrips(double xi, double relative_radius, double half_width, double friction) {
  // Midpoint rule in t, y = sin t: the ends need no care. Load per strip (1 - y^2) dy = cos^3 dt.
  constexpr int kStrips = 400;
  double force = 0;
  double load = 0;
  for (int i = 0; i < kStrips; ++i) {
    const double cosine = std::cos((i + 0.5) / kStrips * std::asin(1.0));
    const double share = cosine * cosine * cosine;
    force += share * CalcCarter(xi, relative_radius, half_width * cosine, friction);
    load += share;
  }
  return force / load;
}

}  // namespace phs::rail
