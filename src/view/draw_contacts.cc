#include <vector>

#include "view/palette.h"
#include "view/picture.h"
#include "view/shapes.h"

namespace phs::view {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using rail::Side;

namespace {

constexpr double kLine = 0.0008;  ///< half the width of an outline [m]

/// A closed line through places that `at` gives for the points of an outline.
template <typename Place>
void DrawOutline(const std::vector<Vector2d>& outline, Place at, const Colour& colour, Pen* pen) {
  for (size_t k = 0; k < outline.size(); ++k) {
    pen->Capsule(at(outline[k]), at(outline[(k + 1) % outline.size()]), kLine, colour, kMatt);
  }
}

}  // namespace

void DrawContacts(const Picture& picture, Pen* pen) {
  const plugin::Binding& binding = picture.model->binding();
  const rail::WheelRail& wheel_rail = binding.wheel_rail();
  const double radius = wheel_rail.params().wheel_radius;
  const std::vector<Vector2d> outline = WheelOutline(wheel_rail);
  for (size_t i = 0; i < binding.wheelsets().size(); ++i) {
    const int body = binding.wheelsets()[i].body;
    const Vector3d axle = picture.BodyAxes(body).col(1);
    const Vector3d down = -(Vector3d::UnitZ() - axle * axle.z()).normalized();
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const double hand = side == Side::kLeft ? 1 : -1;
      const Vector3d tape =
          picture.BodyAt(body) + axle * hand * WheelPosition(wheel_rail) + down * radius;
      DrawOutline(
          outline,
          [&](const Vector2d& p) -> Vector3d { return tape + axle * hand * p.x() + down * p.y(); },
          {0.05f, 0.15f, 0.55f, 1}, pen);
      // The rail is cut where the wheelset stands.
      const Vector3d world = picture.BodyAt(body) + picture.origin;
      const rail::Track& track = binding.track();
      const double s = track.Project({world.x(), world.y(), world.z()});
      const rail::TrackFrame frame = track.FrameAt(s);
      const rail::RailOffset offset = track.Rail(side, s);
      const Vector3d left = ToEigen(frame.left);
      const Vector3d up = ToEigen(frame.up);
      const Vector3d foot = ToEigen(frame.origin) - picture.origin + up * offset.vertical +
                            left * (hand * RailPosition(wheel_rail) + offset.lateral);
      DrawOutline(
          picture.model->rail_section().point,
          [&](const Vector2d& p) -> Vector3d { return foot + left * hand * p.x() + up * p.y(); },
          {0.75f, 0.15f, 0.05f, 1}, pen);
      Vector3d contact;
      if (!ContactPoint(picture, i, side, &contact)) continue;
      pen->Ball(contact, Matrix3d::Identity(), {0.006, 0.005, 0.0015}, {0.95f, 0.1f, 0.1f, 1},
                kGlow);
    }
  }
}

}  // namespace phs::view
