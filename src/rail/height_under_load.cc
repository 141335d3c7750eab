#include "rail/height_under_load.h"

#include <algorithm>
#include <cmath>

#include "base/rising_root.h"

namespace phs::rail {

bool FindHeightUnderLoad(const WheelRail& pair, const WheelUnderLoad& wheel, WheelsetMotion* motion,
                         WheelRailForces* forces) {
  constexpr double kStep = 0.1e-3;  // about as deep as a loaded wheel sinks [m]
  constexpr double kTolerance = 1e-13;
  const auto carry = [&](double height) {
    motion->vertical = height;
    pair.Calc(*motion, wheel.side, wheel.rail, wheel.support, forces);
    return wheel.carried(*forces);
  };
  const auto excess = [&](double height) {
    return std::pow(std::max(0.0, carry(height)) / wheel.load, 2.0 / 3.0) - 1;
  };
  const auto height = RisingRoot(excess, {wheel.near, kStep, wheel.reach, kTolerance});
  if (!height) return false;
  carry(*height);
  return forces->count > 0;
}

}  // namespace phs::rail
