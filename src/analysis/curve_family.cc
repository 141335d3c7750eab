#include "analysis/curve_family.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/data_path.h"
#include "base/gravity.h"
#include "rail/track.h"

namespace phs::analysis {
namespace {

constexpr double kRampSlope = 1e-3;
constexpr double kShortestTransition = 30;  ///< [m]

bool In(double value, double low, double high) { return value >= low && value <= high; }

Status CheckFamily(const CurveFamily& f) {
  if (In(f.speed_limit_m_s, 1, 100) && In(f.largest_cant_m, 0, 0.2) &&
      In(f.deficiency_m, -0.1, 0.2) && f.largest_cant_m + f.deficiency_m > 0) {
    return {};
  }
  return Error{"curves", "are out of range",
               "speed 1 … 100 m/s, cant 0 … 0.2 m, deficiency -0.1 … 0.2 m, their sum > 0", ""};
}

}  // namespace

CurveFamily FamilyOn(const TrackBase& base) {
  CurveFamily family;
  const double wider = base.cant_base_m / family.base.cant_base_m;
  family.largest_cant_m *= wider;
  family.deficiency_m *= wider;
  family.base = base;
  return family;
}

Result<FamilyCurve> CurveOfRadius(const CurveFamily& f, double radius_m) {
  if (!In(radius_m, 80, 20000)) {
    return Error{"radius", "is " + fmt::format("{:g} m", radius_m), "80 … 20000 m", ""};
  }
  if (Status s = CheckFamily(f); !s.ok()) return s.error();
  FamilyCurve curve;
  curve.radius_m = radius_m;
  const double per_speed = f.base.cant_base_m / (kGravity * radius_m);
  curve.speed_m_s =
      std::min(f.speed_limit_m_s, std::sqrt((f.largest_cant_m + f.deficiency_m) / per_speed));
  curve.cant_m = std::max(0.0, per_speed * curve.speed_m_s * curve.speed_m_s - f.deficiency_m);
  curve.transition_m = std::max(kShortestTransition, curve.cant_m / kRampSlope);
  return curve;
}

Result<FamilyCurve> FirstArc(const CurveFamily& f, const std::string& track) {
  if (Status s = CheckFamily(f); !s.ok()) return s.error();
  auto path = FindData("track", "models/tracks", track, {".yaml"});
  if (!path.ok()) return path.error();
  auto loaded = rail::Track::Load(path.value());
  if (!loaded.ok()) return loaded.error();
  const rail::Track& t = loaded.value();
  for (const rail::TrackSection& section : t.sections()) {
    if (section.kind != "curve") continue;
    const rail::TrackFrame middle = t.FrameAt(0.5 * (section.begin_s + section.end_s));
    FamilyCurve curve;
    curve.radius_m = 1 / std::abs(section.curvature);
    curve.hand = section.curvature > 0 ? 1 : -1;
    curve.cant_m = t.cant_base() * std::sin(std::abs(middle.cant));
    const double allowed = std::max(0.0, curve.cant_m + f.deficiency_m);
    curve.speed_m_s =
        std::min(f.speed_limit_m_s, std::sqrt(allowed * kGravity * curve.radius_m / t.cant_base()));
    if (curve.speed_m_s < 1) {
      return Error{"track '" + t.name() + "'", "allows no speed with this cant deficiency", "",
                   "raise --deficiency"};
    }
    return curve;
  }
  return Error{"track '" + t.name() + "'", "has no circular arc", "a curve, or --radii", ""};
}

Result<TemporaryTrack> TrackOf(const CurveFamily& f, const FamilyCurve& c) {
  return TemporaryTrack::Curve(f.base, {c.radius_m, c.cant_m, c.transition_m, f.arc_length_m});
}

}  // namespace phs::analysis
