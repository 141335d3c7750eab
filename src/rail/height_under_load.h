// How deep a wheel lies under its load.
#pragma once

#include <functional>

#include "rail/wheel_rail.h"

namespace phs::rail {

/// What is sought: the height at which `carried` of the forces is `load`.
struct WheelUnderLoad {
  Side side = Side::kRight;
  RailOffset rail{};
  RailSupport support{};
  double load = 0;  ///< [N], > 0
  /// The part of the forces that carries the load [N]: as a rule the vertical force.
  std::function<double(const WheelRailForces&)> carried;
  double near = 0;   ///< height from which it is looked for [m]
  double reach = 0;  ///< how far from there [m]
};

inline double VerticalForce(const WheelRailForces& forces) { return -forces.force[2]; }
inline double ElasticVerticalForce(const WheelRailForces& forces) {
  return -forces.elastic_force[2];
}

/// Sets the height z (down) of the wheelset's centre so that the wheel carries its load, to 1e-13 m, and gives
/// the forces there; false where no height within reach does. The rest of `motion` stays. With N the
/// force carried and Q the load it is the root of (N/Q)^(2/3) - 1, which is nearly a straight line of
/// the depth (Hertz: N ~ depth^(3/2)) and rises with it.
bool FindHeightUnderLoad(const WheelRail& pair, const WheelUnderLoad& wheel, WheelsetMotion* motion,
                         WheelRailForces* forces);

}  // namespace phs::rail
