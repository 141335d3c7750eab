#include <cmath>

#include "view/palette.h"
#include "view/picture.h"
#include "view/pose.h"
#include "view/shapes.h"

namespace phs::view {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using rail::Side;

constexpr double kArrow = 0.022;    ///< width [m]
constexpr double kShortest = 0.02;  ///< shorter arrows are left away [m]

std::string WheelChannel(const plugin::WheelsetBinding& w, Side side, const char* what) {
  return w.name + (side == Side::kLeft ? "_left_" : "_right_") + what;
}

/// An arrow that pushes: its head on the point; one that pulls begins there.
void DrawArrow(const Vector3d& at, const Vector3d& force, bool push, const Colour& colour,
               Pen* pen) {
  if (force.norm() < kShortest) {
    pen->Skip();
    return;
  }
  if (push) {
    pen->Arrow(at - force, at, kArrow, colour);
  } else {
    pen->Arrow(at, at + force, kArrow, colour);
  }
}

/// Forces of the rail on one wheel, beside its outer face at the height of the contact.
void DrawWheelForces(const Picture& picture, size_t index, Side side, Pen* pen) {
  const plugin::WheelsetBinding& w = picture.model->binding().wheelsets()[index];
  Vector3d contact;
  if (!ContactPoint(picture, index, side, &contact)) {
    pen->Skip(3);
    return;
  }
  const Matrix3d axes = picture.BodyAxes(w.body);
  const double hand = side == Side::kLeft ? 1 : -1;
  const Vector3d outward = hand * axes.col(1);
  const Vector3d up = Vector3d::UnitZ();
  const Vector3d forward = axes.col(1).cross(up).normalized();
  const Vector3d beside = contact + 0.13 * outward + 0.03 * up;
  const double guiding = picture.Value(WheelChannel(w, side, "Y_N"));
  const double load = picture.Value(WheelChannel(w, side, "Q_N"));
  const double drive = picture.Value(WheelChannel(w, side, "X_N"));
  // The rail pushes the wheel inwards where the wheel pushes the rail outwards (Y > 0).
  DrawArrow(beside, -outward * guiding * kGuidingScale, guiding > 0, kGuidingColour, pen);
  DrawArrow(beside + 0.02 * outward, up * load * kLoadScale, false, kLoadColour, pen);
  DrawArrow(beside, forward * drive * kGuidingScale, false, kForwardColour, pen);
}

/// The force of each cylinder on its second eye, beside the cylinder.
void DrawCylinderForces(const Picture& picture, Pen* pen) {
  const plugin::Binding& binding = picture.model->binding();
  const mjModel* m = picture.model->model();
  for (size_t p = 0; p < binding.phs().size(); ++p) {
    const plugin::PhsBinding& phs = binding.phs()[p];
    for (size_t i = 0; i < phs.cylinder.size(); ++i) {
      const int actuator = phs.cylinder[i];
      if (m->actuator_trntype[actuator] != mjTRN_TENDON) continue;
      const int tendon = m->actuator_trnid[2 * actuator];
      const int first = m->tendon_adr[tendon];
      const int last = first + m->tendon_num[tendon] - 1;
      if (m->wrap_type[first] != mjWRAP_SITE || m->wrap_type[last] != mjWRAP_SITE) continue;
      const Vector3d a = picture.SiteAt(m->wrap_objid[first]);
      const Vector3d b = picture.SiteAt(m->wrap_objid[last]);
      const Vector3d along = (b - a).normalized();
      const int frame = m->site_bodyid[m->wrap_objid[first]];
      const Vector3d left = picture.BodyAxes(frame).col(1);
      const Vector3d outward = left.dot(a - picture.BodyAt(frame)) < 0 ? -left : left;
      const std::string name = "cylinder_" + phs.system->cylinder_names()[i] + "_force_N";
      const double tension = picture.Value(PhsChannel(binding, p, name));
      DrawArrow(b + 0.16 * outward, -along * tension * kCylinderScale, false,
                tension > 0 ? kPullColour : kPushColour, pen);
    }
  }
}

}  // namespace

bool ContactPoint(const Picture& picture, size_t index, Side side, Vector3d* point) {
  const plugin::Binding& binding = picture.model->binding();
  const plugin::WheelsetBinding& w = binding.wheelsets()[index];
  if (!(picture.Value(WheelChannel(w, side, "contacts")) > 0)) return false;
  const double y = picture.Value(WheelChannel(w, side, "contact_y_m"));
  const rail::Profile* profile = binding.wheel_rail().wheel_profile();
  const double depth = profile == nullptr ? 0 : profile->At(y).z;
  const double hand = side == Side::kLeft ? 1 : -1;
  const Vector3d axle = picture.BodyAxes(w.body).col(1);
  const Vector3d down = -(Vector3d::UnitZ() - axle * axle.z()).normalized();
  *point = picture.BodyAt(w.body) + axle * hand * (WheelPosition(binding.wheel_rail()) + y) +
           down * (binding.wheel_rail().params().wheel_radius + depth);
  return true;
}

void DrawForces(const Picture& picture, Pen* pen) {
  for (size_t i = 0; i < picture.model->binding().wheelsets().size(); ++i) {
    DrawWheelForces(picture, i, Side::kLeft, pen);
    DrawWheelForces(picture, i, Side::kRight, pen);
  }
  DrawCylinderForces(picture, pen);
}

}  // namespace phs::view
