#include "rail/fastsim.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace phs::rail {

CreepForce CalcFastsim(const CreepInput& in, const KalkerCoefficients& c, double shear_modulus,
                       const FastsimGrid& grid) noexcept {
  if (!(in.normal > 0) || !(in.a > 0) || !(in.b > 0)) return {};
  const double pi = std::numbers::pi;
  const double l1 = 8 * in.a / (3 * c.c11 * shear_modulus);
  const double l2 = 8 * in.a / (3 * c.c22 * shear_modulus);
  const double l3 = pi * in.a * std::sqrt(in.a / in.b) / (4 * c.c23 * shear_modulus);
  const double top = in.friction * in.normal / (pi * in.a * in.b) * (grid.elliptic_bound ? 1.5 : 2);
  const double dy = 2 * in.b / grid.strips;
  CreepForce force;
  for (int j = 0; j < grid.strips; ++j) {
    const double y = -in.b + (j + 0.5) * dy;
    const double height = 1 - y * y / (in.b * in.b);
    const double half = in.a * std::sqrt(height);
    const double dx = 2 * half / grid.slices;
    const double grow_x = in.xi / l1 - in.phi * y / l3;
    double px = 0;
    double py = 0;
    double sum_x = 0;
    double sum_y = 0;
    double sum_m = 0;
    for (int i = 0; i < grid.slices; ++i) {
      const double x = half - (i + 0.5) * dx;
      // From the last centre (or the leading edge) to this one; spin acts at the middle of the way.
      const double way = i == 0 ? 0.5 * dx : dx;
      px -= way * grow_x;
      py -= way * (in.eta / l2 + in.phi * (x + 0.5 * way) / l3);
      const double r = std::max(0.0, height - x * x / (in.a * in.a));
      const double bound = top * (grid.elliptic_bound ? std::sqrt(r) : r);
      const double size = std::sqrt(px * px + py * py);
      if (size > bound) {
        const double cut = bound / size;
        px *= cut;
        py *= cut;
      }
      sum_x += px;
      sum_y += py;
      sum_m += x * py - y * px;
    }
    force.x += sum_x * dx * dy;
    force.y += sum_y * dx * dy;
    force.moment += sum_m * dx * dy;
  }
  return force;
}

}  // namespace phs::rail
