// The lines of a PHS: which chambers share one is the model's; the way of the pipes is ours.
//
// A pipe leaves a cylinder upwards, follows the frame inside of its side sill to the middle of the
// bogie, crosses there on the transom at a place of its own, and goes out likewise. Reservoirs and
// accumulators stand on the crossing, spheres of their real volume with 6 mm of wall.
#include <cmath>
#include <vector>

#include "view/palette.h"
#include "view/picture.h"
#include "view/pose.h"

namespace phs::view {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPipe = 0.011;             ///< radius [m]
constexpr double kInward = 0.135;           ///< of a pipe along the frame against its port [m]
constexpr double kAbove[2] = {0.27, 0.31};  ///< of rod and bore pipes there above the ports [m]
constexpr double kCrossing = 0.52;          ///< height of the crossings above the ports [m]
constexpr double kLaneSpacing = 0.13;       ///< of the crossings along the frame [m]

/// Where a line begins: in the frame's axes.
struct Port {
  Vector3d place;
  bool rod = false;
};

struct Frame {
  Vector3d origin;
  Matrix3d axes;
  Vector3d Local(const Vector3d& p) const { return axes.transpose() * (p - origin); }
  Vector3d World(const Vector3d& p) const { return origin + axes * p; }
};

/// Ports of every line of one PHS and the frame that carries them.
std::vector<std::vector<Port>> PortsOf(const Picture& picture, const plugin::PhsBinding& phs,
                                       Frame* frame) {
  const mjModel* m = picture.model->model();
  const auto& params = phs.system->params();
  std::vector<std::vector<Port>> ports(params.lines.size());
  for (size_t i = 0; i < phs.cylinder.size() && i < params.cylinders.size(); ++i) {
    const int actuator = phs.cylinder[i];
    if (m->actuator_trntype[actuator] != mjTRN_TENDON) continue;
    const int tendon = m->actuator_trnid[2 * actuator];
    const int first = m->tendon_adr[tendon];
    const int last = first + m->tendon_num[tendon] - 1;
    if (m->wrap_type[first] != mjWRAP_SITE || m->wrap_type[last] != mjWRAP_SITE) continue;
    const int bracket = m->wrap_objid[first];
    const int body = m->site_bodyid[bracket];
    *frame = {picture.BodyAt(body), picture.BodyAxes(body)};
    const Vector3d a = frame->Local(picture.SiteAt(bracket));
    const Vector3d b = frame->Local(picture.SiteAt(m->wrap_objid[last]));
    const double above = 0.5 * params.cylinders[i].bore_m + 0.006;
    for (const bool rod : {false, true}) {
      const std::string& line = rod ? params.cylinders[i].rod_line : params.cylinders[i].bore_line;
      for (size_t k = 0; k < params.lines.size(); ++k) {
        if (params.lines[k].name != line) continue;
        ports[k].push_back({a + (rod ? 0.60 : 0.22) * (b - a) + Vector3d(0, 0, above), rod});
      }
    }
  }
  return ports;
}

void DrawPipe(const std::vector<Vector3d>& way, const Frame& frame, const Colour& colour,
              Pen* pen) {
  for (size_t i = 0; i + 1 < way.size(); ++i) {
    pen->Capsule(frame.World(way[i]), frame.World(way[i + 1]), kPipe, colour);
  }
}

/// From a port to the lane at x on its own side; returns where the crossing begins.
Vector3d DrawHalf(const Port& port, double x, const Frame& frame, const Colour& colour, Pen* pen) {
  const double side = port.place.y() < 0 ? -1 : 1;
  const double along = port.place.z() + kAbove[port.rod ? 0 : 1];
  const double y = port.place.y() - side * (kInward + (port.rod ? 0.0 : 0.03));
  const double crossing = port.place.z() + kCrossing;
  Vector3d start(x, y, crossing);
  DrawPipe({port.place,
            {port.place.x(), port.place.y(), port.place.z() + 0.05},
            {port.place.x(), y, port.place.z() + 0.05},
            {port.place.x(), y, along},
            {x, y, along},
            start},
           frame, colour, pen);
  return start;
}

double RadiusOf(double volume_m3) { return std::cbrt(0.75 * volume_m3 / M_PI) + 0.006; }

void DrawLine(const hydraulics::LineParams& line, const std::vector<Port>& ports, double x,
              const Frame& frame, const Colour& colour, Pen* pen) {
  std::vector<Vector3d> starts;
  starts.reserve(ports.size());
  for (const Port& port : ports) starts.push_back(DrawHalf(port, x, frame, colour, pen));
  for (size_t i = 0; i + 1 < starts.size(); ++i) {
    DrawPipe({starts[i], starts[i + 1]}, frame, colour, pen);
  }
  if (starts.empty()) return;
  const double height = starts[0].z();
  const auto vessel = [&](double volume, double y) {
    if (!(volume > 0)) return;
    const double radius = RadiusOf(volume);
    const Vector3d at(x, y, height + radius + 0.02);
    DrawPipe({{x, y, height}, at}, frame, colour, pen);
    pen->Ball(frame.World(at), frame.axes, Vector3d::Constant(radius), colour);
    pen->Cylinder(frame.World(at - Vector3d(0, 0, 0.006)), frame.World(at + Vector3d(0, 0, 0.006)),
                  radius + 0.004, kEyeColour);
  };
  vessel(line.reservoir.volume_m3, 0.12);
  vessel(line.accumulator.volume_m3, -0.12);
}

}  // namespace

void DrawLines(const Picture& picture, Pen* pen) {
  const plugin::Binding& binding = picture.model->binding();
  for (size_t p = 0; p < binding.phs().size(); ++p) {
    const plugin::PhsBinding& phs = binding.phs()[p];
    const auto& lines = phs.system->params().lines;
    Frame frame{Vector3d::Zero(), Matrix3d::Identity()};
    const std::vector<std::vector<Port>> ports = PortsOf(picture, phs, &frame);
    for (size_t k = 0; k < lines.size(); ++k) {
      const std::string channel = PhsChannel(binding, p, "line_" + lines[k].name + "_pressure_Pa");
      const double lane = (0.5 * static_cast<double>(lines.size() - 1) - static_cast<double>(k));
      DrawLine(lines[k], ports[k], kLaneSpacing * lane, frame,
               ScaleColour(picture.pressures.Share(picture.Value(channel))), pen);
    }
  }
}

}  // namespace phs::view
