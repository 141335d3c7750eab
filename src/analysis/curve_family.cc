#include "analysis/curve_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/disk.h"

namespace phs::analysis {
namespace {

constexpr double kGravity = 9.81;
constexpr double kRampSlope = 1e-3;
constexpr double kShortestTransition = 30;  ///< [m]

bool In(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

Result<FamilyCurve> CurveOfRadius(const CurveFamily& f, double radius_m) {
  if (!In(radius_m, 80, 20000)) {
    return Error{"radius", "is " + fmt::format("{:g} m", radius_m), "80 … 20000 m", ""};
  }
  if (!In(f.speed_limit_m_s, 1, 100) || !In(f.largest_cant_m, 0, 0.2) ||
      !In(f.deficiency_m, -0.1, 0.2) || f.largest_cant_m + f.deficiency_m <= 0) {
    return Error{"curves", "are out of range",
                 "speed 1 … 100 m/s, cant 0 … 0.2 m, deficiency -0.1 … 0.2 m, their sum > 0", ""};
  }
  FamilyCurve curve;
  curve.radius_m = radius_m;
  const double per_speed = f.cant_base_m / (kGravity * radius_m);
  curve.speed_m_s =
      std::min(f.speed_limit_m_s, std::sqrt((f.largest_cant_m + f.deficiency_m) / per_speed));
  curve.cant_m = std::max(0.0, per_speed * curve.speed_m_s * curve.speed_m_s - f.deficiency_m);
  curve.transition_m = std::max(kShortestTransition, curve.cant_m / kRampSlope);
  return curve;
}

Result<TemporaryTrack> TemporaryTrack::Write(const CurveFamily& f, const FamilyCurve& c) {
  TemporaryTrack track;
  if (Status s = track.folder_.status(); !s.ok()) return s.error();
  const std::string text = fmt::format(
      "name: arc_r{:g}\ngauge_m: {}\ngauge_height_m: 0.014\ncant_pivot: low_rail\ncant_base_m: {}\n"
      "segments:\n  - {{kind: tangent, length_m: 40}}\n  - {{kind: transition, length_m: {}}}\n"
      "  - {{kind: curve, hand: left, radius_m: {}, length_m: {}, cant_m: {}}}\n"
      "  - {{kind: transition, length_m: {}}}\n  - {{kind: tangent, length_m: 20}}\n",
      c.radius_m, f.gauge_m, f.cant_base_m, c.transition_m, c.radius_m, f.arc_length_m, c.cant_m,
      c.transition_m);
  if (Status s = WritePassingFile(track.path(), text); !s.ok()) return s.error();
  return track;
}

}  // namespace phs::analysis
