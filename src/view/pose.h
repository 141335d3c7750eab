// Joint positions of a vehicle from what a run recorded.
//
// Recorded are, per wheelset, its place along and across the track, its heading, its yaw in the
// frame, and the force of each cylinder. A wheelset rests on both rails there (height and roll from
// the profiles). All else, frame, boxes sideways, car body, is put where it stands in static
// balance with that: springs and linkages of the model, weight, and the centrifugal force v^2/R,
//     minimise energy(q)  so that  A(q) = what was recorded.
// Newton's steps with multipliers,  [K A'; A -c] [dq; l] = [f; r],  K the springs, c a tiny
// compliance that lets redundant records be. Oscillations of the sprung masses are not recorded and
// not drawn.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <vector>

#include "plugin/binding.h"
#include "view/recording.h"

namespace phs::view {

class Poser {
 public:
  Poser(mjModel* m, const plugin::Binding& binding, const Recording& recording);
  /// Fills qpos (in the world of the track) and all that follows from it by kinematics.
  void Pose(const Moment& at, mjData* d) const;
  /// Turns every wheelset about its axle to where it stood at the start; then kinematics.
  void StopWheels(mjData* d) const;
  /// Arc length between the outer wheelsets' [m].
  double MiddleOfVehicle(const Moment& at) const;

 private:
  struct Wheelset {
    int body, spin_joint, yaw_joint;
    int x, y, lateral, attack, yaw;  ///< columns of the recording, -1: not recorded
  };
  struct Cylinder {
    int tendon, force;
  };
  /// Where a wheelset stands: centre and direction of its axle (to the left).
  struct Place {
    Eigen::Vector3d centre, axle, up, forward;
    double s = 0;
  };
  Place PlaceOf(const Wheelset& wheelset, const Moment& at) const;
  void Start(const std::vector<Place>& places, mjData* d) const;
  /// Generalised forces of springs, weight and cylinders.
  Eigen::VectorXd Forces(const Moment& at, mjData* d) const;
  Eigen::MatrixXd Stiffness(const mjData* d) const;
  void Step(const std::vector<Place>& places, const Moment& at, mjData* d) const;

  mjModel* m_;
  const plugin::Binding& binding_;
  const Recording& recording_;
  std::vector<Wheelset> wheelsets_;
  std::vector<Cylinder> cylinders_;
  std::vector<char> is_spin_;  ///< [dof]
  int speed_ = -1, curvature_ = -1;
};

/// Channel name of a part of a PHS: with the system's name before it where there are several.
std::string PhsChannel(const plugin::Binding& binding, size_t phs, const std::string& name);

}  // namespace phs::view
