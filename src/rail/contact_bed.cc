#include "rail/contact_bed.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {
namespace {

constexpr double kStep = 0.125e-3;       ///< of the table [m]
constexpr double kPartnerStep = 0.1e-3;  ///< [m]
constexpr double kHalfPatch = 3e-3;      ///< arc length [m]
constexpr double kFlattest = 0.05;       ///< conformal regions carry a wide but finite patch [1/m]

/// Where the wheel falls most steeply inwards.
double FlangeOf(const Profile& wheel) {
  double flange = wheel.min_y() + kHalfPatch;
  for (double y = flange; y < wheel.max_y() - kHalfPatch; y += kPartnerStep) {
    if (wheel.At(y).slope < wheel.At(flange).slope) flange = y;
  }
  return flange;
}

/// From the flange outwards: the first wheel point that is no steeper than the rail; if there is
/// none, the flattest.
double PartnerOf(const Profile& wheel, double flange, double slope) {
  double partner = flange;
  double flattest = wheel.At(partner).slope;
  for (double y = flange; y < wheel.max_y() - kHalfPatch && flattest < slope; y += kPartnerStep) {
    const double there = wheel.At(y).slope;
    if (there > flattest) {
      flattest = there;
      partner = y;
    }
  }
  return partner;
}

/// Mean curvature over the width, from the second difference normal to the surface.
double MeanCurvature(const Profile& p, double y) {
  const double slope = p.At(y).slope;
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  const double dy = kHalfPatch * cosine;
  return (p.At(y + dy).z + p.At(y - dy).z - 2 * p.At(y).z) * cosine / (kHalfPatch * kHalfPatch);
}

}  // namespace

ContactBed::ContactBed(const Profile& wheel, const Profile& rail, double radius,
                       const Hertz& hertz) {
  const int pieces = static_cast<int>(std::ceil((rail.max_y() - rail.min_y()) / kStep));
  begin_ = rail.min_y();
  per_step_ = pieces / (rail.max_y() - begin_);
  last_ = pieces - 1e-9;
  const double flange = FlangeOf(wheel);
  std::vector<double> raw;
  for (int i = 0; i <= pieces; ++i) {
    const double y = begin_ + i / per_step_;
    const double slope = rail.At(y).slope;
    const double across =
        0.5 * (MeanCurvature(rail, y) - MeanCurvature(wheel, PartnerOf(wheel, flange, slope)));
    const double along = 0.5 / (radius * std::sqrt(1 + slope * slope));
    raw.push_back(hertz.BedModulus(along, std::max(across, kFlattest)));
  }
  const int half = static_cast<int>(std::lround(kHalfPatch * per_step_));
  for (int i = 0; i <= pieces; ++i) {
    double sum = 0;
    double weights = 0;
    for (int j = std::max(0, i - half); j <= std::min(pieces, i + half); ++j) {
      const double weight = 1 - std::abs(j - i) / (1.0 + half);
      sum += weight * raw[static_cast<size_t>(j)];
      weights += weight;
    }
    bed_.push_back(sum / weights);
  }
}

}  // namespace phs::rail
