// Plain curves of any radius, alike but for the radius: tangent, transition, arc, on the gauge of
// the product's lines. Speed and cant follow one rule, so that results over radius show the radius:
//   V = min(V_limit, sqrt(g R (cant_max + deficiency)/e)),  cant = e V^2/(g R) - deficiency >= 0
// with e the distance of the running lines. Transition: cant ramp 1 in 1000, but at least 30 m.
#pragma once

#include <string>

#include "base/local_folder.h"
#include "base/result.h"

namespace phs::analysis {

struct CurveFamily {
  double gauge_m = 1.067;
  double cant_base_m = 1.139;         ///< e
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
};

/// Errors: radius outside 80 … 20000 m, family out of range.
Result<FamilyCurve> CurveOfRadius(const CurveFamily& family, double radius_m);

/// A track file of the curve in a temporary folder of its own; removed with the object.
class TemporaryTrack {
 public:
  static Result<TemporaryTrack> Write(const CurveFamily& family, const FamilyCurve& curve);
  std::string path() const { return folder_.path() + "/curve.yaml"; }

 private:
  TemporaryTrack() = default;
  LocalFolder folder_;
};

}  // namespace phs::analysis
