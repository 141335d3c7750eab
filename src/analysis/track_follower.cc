#include "analysis/track_follower.h"

namespace phs::analysis {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kFrameStep = 0.25;  ///< of differences along the track [m]

}  // namespace

Matrix3d Axes(const rail::TrackFrame& f) {
  Matrix3d axes;
  for (int i = 0; i < 3; ++i) {
    const size_t k = static_cast<size_t>(i);
    axes(i, 0) = f.forward[k];
    axes(i, 1) = f.left[k];
    axes(i, 2) = f.up[k];
  }
  return axes;
}

Vector3d Origin(const rail::TrackFrame& f) { return {f.origin[0], f.origin[1], f.origin[2]}; }

Vector3d Turn(const Matrix3d& from, const Matrix3d& to) {
  const Eigen::AngleAxisd rotation(Matrix3d(to * from.transpose()));
  return rotation.angle() * rotation.axis();
}

TrackFollower::TrackFollower(const mjModel* m, const rail::Track& track, int joint)
    : track_(track), qpos_(m->jnt_qposadr[joint]), dof_(m->jnt_dofadr[joint]) {}

void TrackFollower::Start(const mjData* d) {
  const mjtNum* p = d->qpos + qpos_;
  Stand(track_.Project({p[0], p[1], p[2]}));
}

void TrackFollower::Stand(double s) {
  s_ = s;
  for (int i = 0; i < 3; ++i) {
    const rail::TrackFrame f = track_.FrameAt(s + (i - 1) * kFrameStep);
    axes_[i] = Axes(f);
    origin_[i] = Origin(f);
  }
  const Vector3d first = Turn(axes_[0], axes_[1]) / kFrameStep;
  const Vector3d second = Turn(axes_[1], axes_[2]) / kFrameStep;
  turn_ = 0.5 * (first + second);
  bend_ = (second - first) / kFrameStep;
}

void TrackFollower::MoveTo(double s, mjData* d) {
  const rail::TrackFrame from = track_.FrameAt(s_);
  const rail::TrackFrame to = track_.FrameAt(s);
  const Matrix3d turn = Axes(to) * Axes(from).transpose();
  Eigen::Map<Vector3d> place(d->qpos + qpos_);
  place = Origin(to) + turn * (place - Origin(from));
  const Eigen::Quaterniond q(turn);
  mjtNum delta[4] = {q.w(), q.x(), q.y(), q.z()}, old[4];
  mju_copy4(old, d->qpos + qpos_ + 3);
  mju_mulQuat(d->qpos + qpos_ + 3, delta, old);
  mju_normalize4(d->qpos + qpos_ + 3);
  Stand(s);
}

void TrackFollower::Follow(double speed, mjData* d, VectorXd* expected) const {
  const Eigen::Map<const Vector3d> place(d->qpos + qpos_);
  const Vector3d offset = axes_[1].transpose() * (place - origin_[1]);
  const Vector3d before = origin_[0] + axes_[0] * offset;
  const Vector3d after = origin_[2] + axes_[2] * offset;
  const Vector3d here = origin_[1] + axes_[1] * offset;
  const double h = kFrameStep;
  Eigen::Map<Vector3d>(d->qvel + dof_) = speed * (after - before) / (2 * h);
  expected->segment<3>(dof_) = speed * speed * (after - 2 * here + before) / (h * h);
  mjtNum body[9];
  mju_quat2Mat(body, d->qpos + qpos_ + 3);
  const Matrix3d to_body =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body).transpose();
  Eigen::Map<Vector3d>(d->qvel + dof_ + 3) = to_body * (speed * turn_);
  expected->segment<3>(dof_ + 3) = to_body * (speed * speed * bend_);
}

}  // namespace phs::analysis
