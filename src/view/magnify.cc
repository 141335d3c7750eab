#include "view/magnify.h"

#include <cmath>

#include "view/shapes.h"

namespace phs::view {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using RowMatrix = Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>;

void Turn(const Matrix3d& turn, const Vector3d& about, const Vector3d& shift, mjtNum* position,
          mjtNum* axes) {
  Eigen::Map<Vector3d> p(position);
  Eigen::Map<RowMatrix> r(axes);
  p = about + turn * (p - about).eval() + shift;
  r = (turn * r).eval();
}

}  // namespace

void Magnify(const mjModel* m, const rail::Track& track, const Vector3d& origin,
             const Magnification& by, mjData* d) {
  if (!by.any()) return;
  for (int body = 1; body < m->nbody; ++body) {
    const Vector3d at = Eigen::Map<const Vector3d>(d->xpos + 3 * body);
    const Vector3d world = at + origin;
    const rail::TrackFrame frame = track.FrameAt(track.Project({world.x(), world.y(), world.z()}));
    const Vector3d left = ToEigen(frame.left);
    const mjtNum* r = d->xmat + 9 * body;
    const Vector3d own_left(r[1], r[4], r[7]);
    const double yaw = std::atan2(-own_left.dot(ToEigen(frame.forward)), own_left.dot(left));
    const double lateral = left.dot(world - ToEigen(frame.origin));
    const Matrix3d turn =
        Eigen::AngleAxisd((by.yaw - 1) * yaw, ToEigen(frame.up)).toRotationMatrix();
    const Vector3d shift = left * (by.lateral - 1) * lateral;
    for (int g = 0; g < m->body_geomnum[body]; ++g) {
      const int geom = m->body_geomadr[body] + g;
      Turn(turn, at, shift, d->geom_xpos + 3 * geom, d->geom_xmat + 9 * geom);
    }
    for (int site = 0; site < m->nsite; ++site) {
      if (m->site_bodyid[site] == body) {
        Turn(turn, at, shift, d->site_xpos + 3 * site, d->site_xmat + 9 * site);
      }
    }
    Turn(turn, at, shift, d->xpos + 3 * body, d->xmat + 9 * body);
  }
}

}  // namespace phs::view
