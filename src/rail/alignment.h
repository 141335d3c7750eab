// The design geometry of a track: plan, height, cant and gauge widening over arc length s, the
// track frame at s, and the projection of a point.
//
// Plan. Curvature k(s) is continuous and linear within each segment (tangent 0, curve 1/R, clothoid
// between), so the heading th(s) is quadratic and
//     x' = cos th,   y' = sin th,   th' = k.
// Knots lie so close that the heading turns by at most 0.05 rad between them; from a knot the
// position follows by four-point Gauss-Legendre quadrature with the series of sine and cosine,
// whose truncation lies below 1e-16 of the distance. All formulas are odd in k, so a mirrored track
// is mirrored to the last bit.
//
// Cant. Superelevation h(s) [m] over the base e (distance of the running lines of both rails) gives
// the angle asin(h/e); h > 0 raises the right rail (curve to the left). About the low rail the
// centre line rises by |h|/2, about the centre line it stays. The plan is that of the point midway
// between the rail tops, so there is no lateral shift from cant.
//
//          z_T                         left-hand curve, h > 0 (seen along x_T):
//           |  _____ right rail raised by h
//    left o-+--            angle asin(h/e) between y_T and the horizontal
//
// Height. z(s) = gradient polyline with parabolic vertical curves + the rise from cant. The arc
// length s is measured in plan; x_T follows the centre line in space:
//     x_T = (cos th, sin th, z')/sqrt(1 + z'^2),  y_T = cos(cant) y_0 - sin(cant) x_T x y_0,
//     y_0 = (-sin th, cos th, 0),  z_T = x_T x y_T.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "rail/alignment_polyline.h"
#include "rail/track_frame.h"

namespace phs::rail {

enum class SegmentKind { kTangent, kTransition, kCurve };
enum class CantPivot { kLowRail, kCentreLine };

/// One segment with its values at both ends; curvature, cant and widening are linear in between.
struct TrackSegment {
  SegmentKind kind = SegmentKind::kTangent;
  double length = 0;           ///< in plan, > 0 [m]
  double curvature_begin = 0;  ///< > 0 curving left [1/m]
  double curvature_end = 0;
  double cant_begin = 0;  ///< superelevation, > 0 raises the right rail [m]
  double cant_end = 0;
  double widening_begin = 0;  ///< gauge widening [m]
  double widening_end = 0;
  double gradient = 0;  ///< rise per length in plan, > 0 uphill [1]
  std::string where;    ///< file:line for messages
};

struct AlignmentParams {
  std::vector<TrackSegment> segments;
  double cant_base = 1.137;  ///< distance of the running lines e [m]
  CantPivot pivot = CantPivot::kLowRail;
  double vertical_radius = 5000;  ///< of the vertical curves between gradients [m]
  double ramp_rounding = 6;       ///< length of the parabolas at the ends of ramps [m]
};

/// Immutable. Queries are const, allocation-free and thread-safe.
class Alignment {
 public:
  /// Fails where curvature, cant or widening jump, vertical curves do not fit, the track ends in a
  /// curve, or comes so near to itself that a point could not be projected without history.
  static Result<Alignment> Create(const AlignmentParams& params);

  double length() const { return knots_.back().s; }
  TrackFrame FrameAt(double s) const noexcept;
  double Project(const Vec3& point) const noexcept;
  /// Gauge widening [m] and its slope.
  Quadratic WideningAt(double s) const noexcept;
  /// d(cant angle)/ds [rad/m], the twist of the track.
  double TwistAt(double s) const noexcept;
  /// Curvature in plan, > 0 left [1/m].
  double CurvatureAt(double s) const noexcept;

 private:
  struct Knot {
    double s = 0, x = 0, y = 0;
    double heading = 0, cos_heading = 1, sin_heading = 0;
    double curvature = 0, curvature_rate = 0;
    Quadratic height, cant, widening;
  };
  /// Position and direction in plan at distance u from a knot.
  struct PlanPoint {
    double x, y, turn, cos_heading, sin_heading;
  };
  /// Spatial index: open-addressed hash from a square cell near the track to the knot nearest to
  /// the cell's centre.
  struct Cell {
    std::int32_t ix = 0, iy = 0, knot = -1;
  };

  Alignment() = default;
  void BuildKnots(const AlignmentParams& params, const RoundedPolyline& height,
                  const RoundedPolyline& rise);
  void BuildBuckets();
  Status BuildCells(const AlignmentParams& params);
  const Knot& KnotFor(double s) const noexcept;
  int NearestKnot(const Vec3& point) const noexcept;
  static PlanPoint Advance(const Knot& knot, double u) noexcept;

  double cant_base_ = 1;
  std::vector<Knot> knots_;
  std::vector<std::int32_t>
      bucket_;  ///< [floor(s/width)]: last knot at or before the bucket's begin
  double buckets_per_metre_ = 1;
  std::vector<Cell> cells_;
  std::uint32_t cell_mask_ = 0;
};

}  // namespace phs::rail
