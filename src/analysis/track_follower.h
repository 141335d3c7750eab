// The root of a vehicle carried along the track as one rigid body: its speeds and accelerations
// where every coordinate of the suspension stands still.
//
// At arc length s the track frame has origin o(s) and axes A(s). A root at the fixed offset c from
// it is at o + A c and has, at constant forward speed V, the speed V d/ds and the acceleration V^2
// d2/ds2 of that place, and turns at V kappa, kappa the rotation of the axes per metre. Derivatives
// are central differences over 0.25 m of track.
#pragma once

#include <Eigen/Dense>

#include "plugin/binding.h"
#include "rail/track.h"

namespace phs::analysis {

/// Columns: forward, left, up of a track frame in world axes.
Eigen::Matrix3d Axes(const rail::TrackFrame& frame);
Eigen::Vector3d Origin(const rail::TrackFrame& frame);
/// Rotation vector that takes one attitude to the other, world axes.
Eigen::Vector3d Turn(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to);

/// The vehicle's only free root, which turns with the track frame at its own place.
class TrackFollower {
 public:
  /// `joint`: the free joint.
  TrackFollower(const mjModel* m, const rail::Track& track, int joint);

  int dof() const { return dof_; }
  double s() const { return s_; }
  Eigen::Vector3d forward() const { return axes_[1].col(0); }

  /// Places the follower at the root's own arc length.
  void Start(const mjData* d);
  /// The root already stands at s.
  void Stand(double s);
  /// Keeps the root's place relative to the track frame while that moves to arc length s.
  void MoveTo(double s, mjData* d);
  /// Sets the speeds of the root and gives its expected accelerations at forward speed V.
  void Follow(double speed, mjData* d, Eigen::VectorXd* expected) const;

 private:
  const rail::Track& track_;
  int qpos_;
  int dof_;
  double s_ = 0;
  Eigen::Matrix3d axes_[3];  ///< before, at and after s
  Eigen::Vector3d origin_[3];
  Eigen::Vector3d turn_;  ///< rotation per metre, world [rad/m]
  Eigen::Vector3d bend_;  ///< its change per metre [rad/m^2]
};

}  // namespace phs::analysis
