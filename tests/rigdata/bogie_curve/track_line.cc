#include "track_line.h"

#include <algorithm>
#include <cmath>

namespace bogie_curve {
namespace {

constexpr double kKnots = 0.5;  // distance of stored places [m]

// Rises from 0 to 1 between a and b.
double Ramp(double s, double a, double b) { return std::clamp((s - a) / (b - a), 0.0, 1.0); }

// Integral of Ramp from minus infinity.
double RampIntegral(double s, double a, double b) {
  if (s <= a) return 0;
  if (s >= b) return 0.5 * (b - a) + (s - b);
  return 0.5 * (s - a) * (s - a) / (b - a);
}

}  // namespace

TrackLine::TrackLine(const CurveDesign& design) : design_(design) {
  const double lengths[5] = {design.tangent, design.transition, design.arc, design.transition,
                             design.last_tangent};
  double end = 0;
  for (int i = 0; i < 5; ++i) end_[i] = end += lengths[i];
  // Heading is exact for a curvature that is linear over the step; place by Simpson's rule.
  Knot k{0, 0, 0, 0};
  knots_.push_back(k);
  while (k.s < Length()) {
    const double h = kKnots;
    const double k0 = Curvature(k.s), k1 = Curvature(k.s + 0.5 * h), k2 = Curvature(k.s + h);
    const double middle = k.heading + h / 24 * (5 * k0 + 8 * k1 - k2);
    const double last = k.heading + h / 6 * (k0 + 4 * k1 + k2);
    k.x += h / 6 * (std::cos(k.heading) + 4 * std::cos(middle) + std::cos(last));
    k.y += h / 6 * (std::sin(k.heading) + 4 * std::sin(middle) + std::sin(last));
    k.heading = last;
    k.s += h;
    knots_.push_back(k);
  }
}

double TrackLine::Curvature(double s) const {
  return (Ramp(s, end_[0], end_[1]) - Ramp(s, end_[2], end_[3])) / design_.radius;
}

double TrackLine::CantIntegral(double s) const {
  return design_.cant * (RampIntegral(s, end_[0], end_[1]) - RampIntegral(s, end_[2], end_[3]));
}

double TrackLine::Cant(double s) const {
  const double half = design_.rounding / 2;
  return (CantIntegral(s + half) - CantIntegral(s - half)) / design_.rounding;
}

LinePose TrackLine::At(double s) const {
  const double place = std::clamp(s, 0.0, knots_.back().s - kKnots);
  const Knot& k = knots_[static_cast<size_t>(place / kKnots)];
  const double h = s - k.s;  // beyond the ends the track goes on straight
  const double k0 = Curvature(k.s), k1 = Curvature(k.s + 0.5 * h), k2 = Curvature(s);
  const double middle = k.heading + h / 24 * (5 * k0 + 8 * k1 - k2);
  LinePose pose;
  pose.curvature = k2;
  pose.heading = k.heading + h / 6 * (k0 + 4 * k1 + k2);
  const double c = std::cos(pose.heading), n = std::sin(pose.heading);
  const double d = 1e-3;
  const double rise = (Cant(s + d) - Cant(s - d)) / (2 * d);
  const double angle = std::asin(Cant(s) / design_.base);
  pose.origin = {k.x + h / 6 * (std::cos(k.heading) + 4 * std::cos(middle) + c),
                 k.y + h / 6 * (std::sin(k.heading) + 4 * std::sin(middle) + n), 0.5 * Cant(s)};
  pose.forward = Vector3d(c, n, 0.5 * rise).normalized();
  const Vector3d level(-n, c, 0);
  pose.left = std::cos(angle) * level - std::sin(angle) * pose.forward.cross(level);
  pose.up = pose.forward.cross(pose.left);
  pose.twist = rise / (design_.base * std::cos(angle));
  return pose;
}

double TrackLine::Project(const Vector3d& point, double near) const {
  double s = near;
  for (int i = 0; i < 20; ++i) {
    const LinePose pose = At(s);
    const Vector3d from = point - pose.origin;
    const double step = from.dot(pose.forward) / (1 - pose.curvature * from.dot(pose.left));
    s += step;
    if (std::abs(step) < 1e-11) break;
  }
  return s;
}

}  // namespace bogie_curve
