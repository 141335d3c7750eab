#include "wheel_on_rail.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bogie_curve {
namespace {

constexpr double kStep = 2.5e-4;   // along the wheel's section [m]
constexpr double kVirtual = 0.55;  // e
constexpr double kFlattest = 0.2;  // least curvature across [1/m]
constexpr double kSharpest = 500;  // largest [1/m]

}  // namespace

WheelOnRail::WheelOnRail(WheelRailPair pair)
    : pair_(std::move(pair)),
      hertz_(pair_.material),
      rail_y_(pair_.gauge / 2 - pair_.rail.InnerFlank(pair_.gauge_depth)) {}

WheelOnRail::Overlap WheelOnRail::Gather(const Sample* begin, const Sample* end) {
  const Sample* top =
      std::max_element(begin, end, [](const Sample& a, const Sample& b) { return a.h < b.h; });
  Overlap patch;
  patch.depth = top->h;
  if (top > begin && top + 1 < end) {  // the summit of the parabola through three samples
    const double rise = top[1].h - top[-1].h, bend = 2 * top->h - top[1].h - top[-1].h;
    if (bend > 0) patch.depth += rise * rise / (8 * bend);
  }
  for (const Sample* s = begin; s < end; ++s) {
    const double g = s->h - (1 - kVirtual) * patch.depth;
    if (g <= 0) continue;
    const double weight = g * kStep * std::sqrt(1 + s->slope * s->slope);
    patch.area += weight;
    patch.rail_y += weight * s->rail_y;
    patch.slope += weight * s->slope;
    patch.radius += weight * s->radius;
  }
  for (double* mean : {&patch.rail_y, &patch.slope, &patch.radius}) *mean /= patch.area;
  return patch;
}

std::vector<WheelOnRail::Overlap> WheelOnRail::Overlaps(const AxlePlace& axle) const {
  const double c = std::cos(axle.roll), n = std::sin(axle.roll);
  std::vector<Overlap> patches;
  static thread_local std::vector<Sample> run;
  run.clear();
  const auto close = [&] {
    if (run.size() > 1) patches.push_back(Gather(run.data(), run.data() + run.size()));
    run.clear();
  };
  for (double at = pair_.wheel.first(); at < pair_.wheel.last(); at += kStep) {
    const double y = pair_.half_tape + at, z = pair_.radius + pair_.wheel.At(at).z;
    const double u = axle.y + y * c - z * n - rail_y_;
    if (!pair_.rail.Has(u)) {
      close();
      continue;
    }
    const Section::Place rail = pair_.rail.At(u);
    const double h = axle.z + y * n + z * c - rail.z;
    if (h <= 0) {
      close();
      continue;
    }
    run.push_back({u, rail.slope, z, h / std::sqrt(1 + rail.slope * rail.slope)});
  }
  close();
  return patches;
}

void WheelOnRail::AddPatch(const AxlePlace& axle, const Overlap& overlap, WheelLoad* load) const {
  Patch patch;
  const double m = overlap.slope, length = std::sqrt(1 + m * m);
  const double height = kVirtual * overlap.depth, width = 0.75 * overlap.area / height;
  const double across = std::clamp(height / (width * width), kFlattest, kSharpest);
  const double along = 0.5 / (length * overlap.radius);
  patch.ellipse = hertz_.At(along, across, overlap.depth);
  patch.rail_y = overlap.rail_y;
  patch.slope = m;
  patch.rolling_radius = overlap.radius;

  const Vector3d e1 = Vector3d(1, 0, axle.rail_fall).normalized();
  const Vector3d n = (Vector3d(0, -m, 1) / length - e1 * (axle.rail_fall / length)).normalized();
  const Vector3d e2 = n.cross(e1);
  Vector3d r(0, rail_y_ + overlap.rail_y - axle.y, pair_.rail.At(overlap.rail_y).z - axle.z);
  r.x() = -axle.yaw * (r.y() * std::cos(axle.roll) + r.z() * std::sin(axle.roll));
  const Vector3d v = axle.speed + axle.turn.cross(r);
  // The patch's approach is damped; it never pulls.
  const double pressed = std::max(
      0.0, patch.ellipse.normal + pair_.damping * v.dot(n) * std::min(1.0, overlap.depth / 1e-5));
  patch.creepage = {v.dot(e1) / axle.forward, v.dot(e2) / axle.forward,
                    axle.turn.dot(n) / axle.forward};
  const CreepWrench creep =
      CalcCreep(patch.ellipse, pair_.material, pair_.friction, patch.creepage);
  patch.force = creep.f1 * e1 + creep.f2 * e2 - pressed * n;
  load->force += patch.force;
  load->moment += r.cross(patch.force) + creep.mn * n;
  load->patches.push_back(patch);
}

WheelLoad WheelOnRail::Load(const AxlePlace& axle) const {
  WheelLoad load;
  for (const Overlap& overlap : Overlaps(axle)) AddPatch(axle, overlap, &load);
  return load;
}

AxleLoad LoadAxle(const WheelOnRail& left, const WheelOnRail& right, const AxleInTrack& axle) {
  AxleLoad out;
  for (size_t side = 0; side < 2; ++side) {
    const WheelOnRail& wheel = side == 0 ? left : right;
    // Axes of one wheel: y to its field side, z down; a left wheel in a mirror.
    const double o = side == 0 ? 1 : -1;
    const Vector3d polar(1, o, -1), axial(-o, -1, o);
    AxlePlace place;
    place.y = o * axle.y, place.z = -axle.z;
    place.roll = -o * axle.roll, place.yaw = o * axle.yaw;
    place.speed = polar.cwiseProduct(axle.speed), place.turn = axial.cwiseProduct(axle.turn);
    place.forward = axle.speed.x();
    // On a ramp the rails turn about the centre line while the axle runs along.
    place.rail_fall = o * wheel.rail_place() * axle.twist;
    out.wheel[side] = wheel.Load(place);
    out.force += polar.cwiseProduct(out.wheel[side].force);
    out.moment += axial.cwiseProduct(out.wheel[side].moment);
  }
  return out;
}

}  // namespace bogie_curve
