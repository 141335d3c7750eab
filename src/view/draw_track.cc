#include <cmath>

#include "view/palette.h"
#include "view/picture.h"
#include "view/shapes.h"

namespace phs::view {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using rail::Side;

constexpr double kSleepersAhead = 70;  ///< drawn before and after the vehicle [m]
constexpr double kClipsAhead = 5;      ///< fastenings, which are small [m]

Matrix3d AxesOf(const rail::TrackFrame& frame) {
  Matrix3d axes;
  axes << ToEigen(frame.forward), ToEigen(frame.left), ToEigen(frame.up);
  return axes;
}

/// Base plate, pad and the two clips of one rail on one sleeper.
void DrawFastening(const Picture& picture, const rail::TrackFrame& frame, double y, Pen* pen) {
  const Matrix3d axes = AxesOf(frame);
  const Vector3d foot = ToEigen(frame.origin) - picture.origin + axes * Vector3d(0, y, kSleeperTop);
  pen->Box(foot + axes * Vector3d(0, 0, 0.006), axes, {0.075, 0.15, 0.006}, kClipColour);
  for (const double side : {-1.0, 1.0}) {
    const Vector3d at = foot + axes * Vector3d(0, side * 0.093, 0.026);
    pen->Box(at - axes * Vector3d(0, side * 0.012, 0.006), axes, {0.035, 0.028, 0.008},
             kClipColour);
  }
}

}  // namespace

void DrawTrack(const Picture& picture, Pen* pen) {
  const plugin::Binding& binding = picture.model->binding();
  const rail::Track& track = binding.track();
  const rail::WheelRail& wheel_rail = binding.wheel_rail();
  const Matrix3d none = Matrix3d::Identity();
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const MeshSlot slot = side == Side::kLeft ? MeshSlot::kRailLeft : MeshSlot::kRailRight;
    picture.model->SetMesh(slot, RailMesh(picture.model->rail_section(), track, wheel_rail, side,
                                          picture.s, picture.origin));
    pen->Mesh(picture.model->MeshId(slot), Vector3d::Zero(), none, kRailColour);
  }
  picture.model->SetMesh(MeshSlot::kBallast, BallastMesh(track, picture.s, picture.origin));
  pen->Mesh(picture.model->MeshId(MeshSlot::kBallast), Vector3d::Zero(), none, kBallastColour,
            kMatt);
  const double half = SleeperHalfLength(track);
  const long first = std::lround((picture.s - kSleepersAhead) / kSleeperSpacing);
  const long last = std::lround((picture.s + kSleepersAhead) / kSleeperSpacing);
  for (long i = first; i <= last; ++i) {
    const double s = static_cast<double>(i) * kSleeperSpacing;
    const rail::TrackFrame frame = track.FrameAt(s);
    const Matrix3d axes = AxesOf(frame);
    const Vector3d at = ToEigen(frame.origin) - picture.origin +
                        axes * Vector3d(0, 0, kSleeperTop - kSleeperHalfHeight);
    pen->Box(at, axes, {kSleeperHalfWidth, half, kSleeperHalfHeight}, kSleeperColour);
    if (std::abs(s - picture.s) > kClipsAhead) continue;
    DrawFastening(picture, frame, RailPosition(wheel_rail), pen);
    DrawFastening(picture, frame, -RailPosition(wheel_rail), pen);
  }
  const rail::TrackFrame here = track.FrameAt(picture.s);
  pen->Box(ToEigen(here.origin) - picture.origin - Vector3d(0, 0, 0.85), none, {400, 400, 0.1},
           kGroundColour);
}

}  // namespace phs::view
