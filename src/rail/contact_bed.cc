#include "rail/contact_bed.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {
namespace {

constexpr double kStep = 0.125e-3;       ///< of the table [m]
constexpr double kPartnerStep = 0.1e-3;  ///< [m]
constexpr double kHalfPatch = 0.5e-3;  ///< half-width of a patch in the flange root, arc length [m]
constexpr double kFlattest = 0.05;       ///< conformal regions carry a wide but finite patch [1/m]

/// The rail point with the wheel's slope, from the rail's inner end outwards; where none is so
/// steep, the end.
double PartnerOf(const Profile& rail, double slope) {
  double y = rail.min_y() + kHalfPatch;
  while (y < rail.max_y() - kHalfPatch && rail.At(y).slope < slope) y += kPartnerStep;
  return y;
}

/// Mean curvature over the width: the turn of the surface over its arc length.
double MeanCurvature(const Profile& p, double y) {
  const double slope = p.At(y).slope;
  const double dy = kHalfPatch / std::sqrt(1 + slope * slope);
  const double from = y - dy;
  const double to = y + dy;
  const double arc = std::hypot(2 * dy, p.At(to).z - p.At(from).z);
  const double turn = std::atan(p.At(to).slope) - std::atan(p.At(from).slope);
  return turn / arc;
}

}  // namespace

ContactBed::ContactBed(const Profile& wheel, const Profile& rail, double radius,
                       const Hertz& hertz) {
  const int pieces = static_cast<int>(std::ceil((wheel.max_y() - wheel.min_y()) / kStep));
  begin_ = wheel.min_y();
  per_step_ = pieces / (wheel.max_y() - begin_);
  last_ = pieces - 1e-9;
  std::vector<double> raw, arc{0};
  for (int i = 0; i <= pieces; ++i) {
    const double y = begin_ + i / per_step_;
    const Profile::Sample s = wheel.At(y);
    const double stretch = std::sqrt(1 + s.slope * s.slope);
    const double across =
        0.5 * (MeanCurvature(rail, PartnerOf(rail, s.slope)) - MeanCurvature(wheel, y));
    const double along = 0.5 / ((radius + s.z) * stretch);
    raw.push_back(hertz.BedModulus(along, std::max(across, kFlattest)));
    arc.push_back(arc.back() + stretch / per_step_);
  }
  for (size_t i = 0; i < raw.size(); ++i) {
    double sum = 0;
    double weights = 0;
    const auto add = [&](size_t j) {
      const double weight = 1 - std::abs(arc[j] - arc[i]) / kHalfPatch;
      if (!(weight > 0)) return false;
      sum += weight * raw[j];
      weights += weight;
      return true;
    };
    for (size_t j = i; j < raw.size() && add(j); ++j) continue;
    for (size_t j = i; j > 0 && add(j - 1); --j) continue;
    bed_.push_back(sum / weights);
  }
}

}  // namespace phs::rail
