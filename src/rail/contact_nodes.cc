#include "rail/contact_nodes.h"

#include <algorithm>
#include <cmath>

#include "rail/arc_mean.h"

namespace phs::rail {
namespace {

constexpr double kDepth = 80e-6;   ///< of a hump under a usual load [m]
constexpr double kNodesInIt = 20;  ///< in that hump
constexpr double kPiece = 0.1e-3;
constexpr double kFlattestHump = 1, kSharpestHump = 60;  ///< B [1/m]
constexpr double kEven = 3e-3;                           ///< half, along the surface [m]
constexpr double kEnd = 1e-3;  ///< curvature is not asked for nearer to an end [m]

double Curvature(const Profile& p, double y) {
  const Profile::Sample s = p.At(std::clamp(y, p.min_y() + kEnd, p.max_y() - kEnd));
  return s.second / std::pow(1 + s.slope * s.slope, 1.5);
}

/// Angle and curvature over a rail.
struct RailPoint {
  double angle, curvature;
};
std::vector<RailPoint> PointsOf(const Profile& rail) {
  std::vector<RailPoint> points;
  const auto count = static_cast<int>((rail.max_y() - rail.min_y()) / kPiece);
  for (int i = 0; i <= count; ++i) {
    const double y = rail.min_y() + kPiece * i;
    points.push_back({std::atan(rail.At(y).slope), Curvature(rail, y)});
  }
  return points;
}

/// The rail's curvature where its slope is nearest to `slope`.
double PartnersCurvature(const std::vector<RailPoint>& rail, double slope) {
  const double angle = std::atan(slope);
  return std::min_element(rail.begin(), rail.end(),
                          [&](const RailPoint& a, const RailPoint& b) {
                            return std::abs(a.angle - angle) < std::abs(b.angle - angle);
                          })
      ->curvature;
}

}  // namespace

ContactNodes::ContactNodes(const Profile& wheel, const Profile& rail, double radius_at_origin,
                           int fineness)
    : begin_(wheel.min_y()) {
  const double width = wheel.max_y() - begin_;
  const auto pieces = static_cast<size_t>(std::ceil(width / kPiece));
  const double piece = width / static_cast<double>(pieces);
  const auto along = [&](double i) { return begin_ + piece * i; };
  per_piece_ = 1 / piece;
  const std::vector<RailPoint> rail_points = PointsOf(rail);
  // [end of a piece] ds/dy, way along the surface, sqrt(B).
  std::vector<double> stretch, arc, root;
  for (size_t i = 0; i <= pieces; ++i) {
    const double y = along(static_cast<double>(i));
    const double slope = wheel.At(y).slope;
    stretch.push_back(std::sqrt(1 + slope * slope));
    arc.push_back(i == 0 ? 0 : arc.back() + 0.5 * piece * (stretch[i - 1] + stretch[i]));
    const double b = 0.5 * (PartnersCurvature(rail_points, slope) - Curvature(wheel, y));
    root.push_back(std::sqrt(std::clamp(b, kFlattestHump, kSharpestHump)));
  }
  const double step = 2 * std::sqrt(kDepth) / (kNodesInIt * fineness);
  const std::vector<double> even = MeanOverArc(
      root, arc, stretch, kEven, [](double away) { return (1 - away * away) * (1 - away * away); });
  for (size_t i = 0; i <= pieces; ++i) {
    density_.push_back(even[i] * stretch[i] / step);
    place_.push_back(i == 0 ? 0 : place_.back() + 0.5 * piece * (density_[i - 1] + density_[i]));
  }
  size_t i = 0;
  for (int k = 0; k <= place_.back(); ++k) {
    while (i + 2 < place_.size() && place_[i + 1] < k) ++i;
    // Density goes linearly over a piece, place with its square.
    const double bend = (density_[i + 1] - density_[i]) * per_piece_;
    const double left = k - place_[i];
    const double beyond =
        2 * left / (density_[i] + std::sqrt(density_[i] * density_[i] + 2 * bend * left));
    at.push_back(along(static_cast<double>(i)) + beyond);
    across.push_back(1 / (density_[i] + bend * beyond));
    const Profile::Sample s = wheel.At(at.back());
    radius.push_back(radius_at_origin + s.z);
    slope.push_back(s.slope);
    second.push_back(s.second);
  }
}

double ContactNodes::PlaceOf(double wheel_y) const noexcept {
  const double place = (wheel_y - begin_) * per_piece_;
  const auto i =
      static_cast<size_t>(std::clamp(place, 0.0, static_cast<double>(place_.size() - 2)));
  return place_[i] + (place - static_cast<double>(i)) * (place_[i + 1] - place_[i]);
}

}  // namespace phs::rail
