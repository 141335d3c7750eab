// Plain curves of any radius, alike but for the radius: tangent, transition, arc, on one gauge.
// Speed and cant follow one rule, so that results over radius show the radius:
//   V = min(V_limit, sqrt(g R (cant_max + deficiency)/e)),  cant = e V^2/(g R) - deficiency >= 0
// with e the distance of the running lines. Transition: cant ramp 1 in 1000, but at least 30 m.
#pragma once

#include <string>

#include "analysis/plain_track.h"
#include "base/result.h"

namespace phs::analysis {

struct CurveFamily {
  TrackBase base;
  double speed_limit_m_s = 80 / 3.6;  ///< 1 … 100
  double largest_cant_m = 0.060;      ///< 0 … 0.2
  double deficiency_m = 0.045;        ///< cant deficiency, -0.1 … 0.2
  double arc_length_m = 300;
};

struct FamilyCurve {
  double radius_m = 0;
  double speed_m_s = 0;
  double cant_m = 0;
  double transition_m = 0;
  int hand = 1;  ///< +1 left-hand, as all of a radius alone are; -1 right-hand
};

/// On another gauge: largest cant and deficiency in proportion to e, so that the unbalanced
/// acceleration, and with it speed over radius, stays.
CurveFamily FamilyOn(const TrackBase& base);

/// Errors: radius outside 80 … 20000 m, family out of range.
Result<FamilyCurve> CurveOfRadius(const CurveFamily& family, double radius_m);

/// The first arc of a track as it lies, with the speed that the family's limit and deficiency
/// allow there. Error: the track has no arc.
Result<FamilyCurve> FirstArc(const CurveFamily& family, const std::string& track);

/// Its track as a temporary file.
Result<TemporaryTrack> TrackOf(const CurveFamily& family, const FamilyCurve& curve);

}  // namespace phs::analysis
