// The bristle of declared friction: the elasto-plastic single-state model of Dupont, Hayward,
// Armstrong and Altpeter (IEEE Trans. Automatic Control 47 (2002) 787), with a blending that
// integrates exactly:
//   dz/dt = v (1 - alpha z/z_s)
//   alpha = 0 for |z| < z_b = r z_s or where z and v point in opposite directions,
//   alpha = (|z| - z_b)/(z_s - z_b) beyond.
// Below z_b the displacement is purely elastic: the piston sticks without creep however long it is
// held or shaken. For v of one sign the plastic part is a Riccati equation with the solution
//   q = (z_s - |z|)/(|z| + z_s - z_b),   q(x) = q(0) exp(-k x)
//   k = (2 z_s - z_b)/(z_s (z_s - z_b))
// so the update over any step is exact and unconditionally stable.
#pragma once

#include <algorithm>
#include <cmath>

namespace phs::hydraulics {

struct ElastoPlastic {
  double ratio = 0;  ///< r, [0, 0.99]

  /// alpha z/z_s at deflection `along` in the direction of motion, z_s > 0.
  double Yield(double along, double z_s) const {
    const double z_b = ratio * z_s;
    return along > z_b ? (along - z_b) / (z_s - z_b) * along / z_s : 0;
  }
  /// Deflection after a way > 0.
  double Advance(double along, double way, double z_s) const {
    const double z_b = ratio * z_s;
    if (along < z_b) {
      const double elastic = std::min(way, z_b - along);
      along += elastic;
      way -= elastic;
    }
    if (way <= 0) return along;
    const double k = (2 * z_s - z_b) / (z_s * (z_s - z_b));
    const double q = (z_s - along) / (along + z_s - z_b) * std::exp(-k * way);
    return (z_s - q * (z_s - z_b)) / (1 + q);
  }
};

}  // namespace phs::hydraulics
