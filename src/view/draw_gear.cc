// Wheels from their profiles, and what stands between moving parts: cylinders of a PHS, and
// tendons by their kind.
#include <algorithm>
#include <string>
#include <vector>

#include "plugin/model_text.h"
#include "view/palette.h"
#include "view/picture.h"
#include "view/pose.h"
#include "view/shapes.h"

namespace phs::view {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A part between two points; `width` as the tendon gives it [m].
struct Span {
  Vector3d a, b;
  double width = 0;
};

void DrawDamper(const Span& span, Pen* pen) {
  const Vector3d along = span.b - span.a;
  const double r = span.width;
  pen->Cylinder(span.a + 0.08 * along, span.a + 0.60 * along, r, kDamperColour);
  pen->Cylinder(span.a + 0.50 * along, span.b - 0.06 * along, 0.45 * r, kChromeColour);
  pen->Cylinder(span.a + 0.55 * along, span.b - 0.25 * along, 1.15 * r, kEyeColour);
  pen->Ball(span.a, Matrix3d::Identity(), Vector3d::Constant(0.9 * r), kEyeColour);
  pen->Ball(span.b, Matrix3d::Identity(), Vector3d::Constant(0.9 * r), kEyeColour);
}

void DrawRod(const Span& span, Pen* pen) {
  pen->Cylinder(span.a, span.b, span.width, kLinkColour);
  pen->Ball(span.a, Matrix3d::Identity(), Vector3d::Constant(1.7 * span.width), kEyeColour);
  pen->Ball(span.b, Matrix3d::Identity(), Vector3d::Constant(1.7 * span.width), kEyeColour);
}

struct Kind {
  const char* name;  ///< the tendon is called NAME:…
  void (*draw)(const Span& span, Pen* pen);
};
/// Springs are not among them: all coils together are one mesh.
constexpr Kind kKinds[] = {{"damper", &DrawDamper}, {"rod", &DrawRod}};
constexpr char kSpring[] = "spring";

/// What a tendon is drawn as: by its name, else by what it does.
std::string KindOf(const mjModel* m, int tendon) {
  const std::string name = plugin::ObjectName(m, mjOBJ_TENDON, tendon);
  const size_t colon = name.find(':');
  if (colon != std::string::npos) {
    std::string kind = name.substr(0, colon);
    for (const char* prefix : {"front_", "rear_"}) {
      if (kind.starts_with(prefix)) kind = kind.substr(std::string(prefix).size());
    }
    return kind;
  }
  if (m->tendon_stiffness[tendon] > 0) return "rod";
  return m->tendon_damping[tendon] > 0 ? "damper" : "";
}

/// Its first and last site; false for tendons along joints.
bool SpanOf(const Picture& picture, int tendon, Span* span) {
  const mjModel* m = picture.model->model();
  const int first = m->tendon_adr[tendon];
  const int last = first + m->tendon_num[tendon] - 1;
  if (m->wrap_type[first] != mjWRAP_SITE || m->wrap_type[last] != mjWRAP_SITE) return false;
  *span = {picture.SiteAt(m->wrap_objid[first]), picture.SiteAt(m->wrap_objid[last]),
           m->tendon_width[tendon]};
  return true;
}

void DrawTendons(const Picture& picture, Pen* pen) {
  const mjModel* m = picture.model->model();
  for (int t = 0; t < m->ntendon; ++t) {
    Span span;
    const std::string kind = KindOf(m, t);
    if (kind.empty() || !SpanOf(picture, t, &span)) continue;
    for (const Kind& known : kKinds) {
      if (kind == known.name) known.draw(span, pen);
    }
  }
}

/// Pressure of a chamber's line as a colour; grey where it is open to the air.
Colour ChamberColour(const Picture& picture, size_t phs, const std::string& line) {
  if (line.empty()) return {0.6f, 0.6f, 0.6f, 1};
  const std::string channel =
      PhsChannel(picture.model->binding(), phs, "line_" + line + "_pressure_Pa");
  if (picture.recording->Find(channel) < 0) return {0.6f, 0.6f, 0.6f, 1};
  return ScaleColour(picture.pressures.Share(picture.Value(channel)));
}

/// Barrel at the first eye, its two chambers in the colours of their pressures, piston between.
void DrawCylinder(const Picture& picture, size_t phs, const hydraulics::CylinderParams& cylinder,
                  const Span& span, double piston, Pen* pen) {
  const Vector3d along = (span.b - span.a).normalized();
  const double length = (span.b - span.a).norm();
  const double r = 0.5 * cylinder.bore_m + 0.012;
  const double begin = 0.14 * length;
  const double end = 0.60 * length - piston;  // the barrel keeps its length
  const double at = std::clamp(0.5 * (begin + end) + piston, begin + 0.01, end - 0.01);
  const auto point = [&](double x) -> Vector3d { return span.a + along * x; };
  pen->Cylinder(point(begin), point(at - 0.006), r,
                ChamberColour(picture, phs, cylinder.bore_line));
  pen->Cylinder(point(at + 0.006), point(end), r, ChamberColour(picture, phs, cylinder.rod_line));
  pen->Cylinder(point(at - 0.006), point(at + 0.006), r + 0.002, kEyeColour);
  pen->Cylinder(point(begin - 0.016), point(begin), r + 0.008, kEyeColour);
  pen->Cylinder(point(end), point(end + 0.016), r + 0.008, kEyeColour);
  pen->Cylinder(point(end), point(length - 0.03), 0.5 * cylinder.rod_m, kChromeColour);
  pen->Cylinder(span.a, point(begin - 0.01), 0.6 * r, kEyeColour);
  for (const Vector3d& eye : {span.a, span.b}) {
    pen->Ball(eye, Matrix3d::Identity(), Vector3d::Constant(0.8 * r), kEyeColour);
  }
}

void DrawCylinders(const Picture& picture, Pen* pen) {
  const plugin::Binding& binding = picture.model->binding();
  const mjModel* m = picture.model->model();
  for (size_t p = 0; p < binding.phs().size(); ++p) {
    const plugin::PhsBinding& phs = binding.phs()[p];
    const auto& params = phs.system->params();
    for (size_t i = 0; i < phs.cylinder.size() && i < params.cylinders.size(); ++i) {
      Span span;
      const int actuator = phs.cylinder[i];
      if (m->actuator_trntype[actuator] != mjTRN_TENDON) continue;
      if (!SpanOf(picture, m->actuator_trnid[2 * actuator], &span)) continue;
      const std::string channel =
          PhsChannel(binding, p, "cylinder_" + params.cylinders[i].name + "_piston_m");
      DrawCylinder(picture, p, params.cylinders[i], span, picture.Value(channel), pen);
    }
  }
}

}  // namespace

std::vector<CoilSpan> CoilsOf(const Picture& picture) {
  const mjModel* m = picture.model->model();
  std::vector<CoilSpan> coils;
  for (int t = 0; t < m->ntendon; ++t) {
    Span span;
    if (KindOf(m, t) != kSpring || !SpanOf(picture, t, &span)) continue;
    const double wire = 0.17 * span.width;
    coils.push_back({span.a, span.b, span.width - wire, wire});
  }
  return coils;
}

void DrawCoils(const Picture& picture, Pen* pen) {
  phs::view::Mesh coils;
  for (const CoilSpan& coil : CoilsOf(picture)) {
    coils.Append(Coil(coil.a, coil.b, coil.radius, coil.wire, kCoilTurns));
  }
  if (coils.vertex.empty()) return;
  picture.model->SetMesh(MeshSlot::kCoils, coils);
  pen->Mesh(picture.model->MeshId(MeshSlot::kCoils), Vector3d::Zero(), Matrix3d::Identity(),
            kCoilColour);
}

void DrawRunningGear(const Picture& picture, bool clear, Pen* pen) {
  Colour wheel = kWheelColour;
  if (clear) wheel.a = 0.35f;
  const plugin::Binding& binding = picture.model->binding();
  const double half = WheelPosition(binding.wheel_rail());
  for (const plugin::WheelsetBinding& w : binding.wheelsets()) {
    const Matrix3d axes = picture.BodyAxes(w.body);
    const Vector3d centre = picture.BodyAt(w.body);
    pen->Mesh(picture.model->MeshId(MeshSlot::kWheelLeft), centre + axes.col(1) * half, axes,
              wheel);
    pen->Mesh(picture.model->MeshId(MeshSlot::kWheelRight), centre - axes.col(1) * half, axes,
              wheel);
  }
  DrawTendons(picture, pen);
  DrawCylinders(picture, pen);
}

}  // namespace phs::view
