// Small angles and shifts made large enough to be seen.
//
// What is magnified is how each body deviates from the track under it: its heading against the
// tangent, and how far its origin lies beside the centre line. The track is drawn as it is. So an
// axle in the radial position stays square to the rails however much is magnified.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>

#include "rail/track.h"

namespace phs::view {

struct Magnification {
  double yaw = 1;
  double lateral = 1;
  bool any() const { return yaw != 1 || lateral != 1; }
};

/// Moves every body with its geoms and sites in `d`, as kinematics left them; `origin` of the world
/// is what stands at zero there.
void Magnify(const mjModel* m, const rail::Track& track, const Eigen::Vector3d& origin,
             const Magnification& by, mjData* d);

}  // namespace phs::view
