// The humps of the overlap: where they are, how far they have grown together, their deepest points.
#include <algorithm>
#include <cmath>

#include "rail/contact_search.h"

namespace phs::rail {
namespace {

constexpr double kSpare = 1.25;     ///< a yawed wheel is more curved across
constexpr double kMostRoll = 0.06;  ///< and other differences of slope at a contact [rad]
/// Humps whose ridge is this near to the shallower one are one hump.
constexpr double kSameHump = 0.98;
constexpr int kMaxRidges = 12;
constexpr double kUsual = 3;  ///< relative curvature across of a first guess [1/m]

/// 0 at 0, 1 at 1, level at both.
double SmoothStep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

void ContactSearch::MeasureMargins() {
  // Where a hump is deepest the slopes of wheel and rail agree, but for the roll; it rises above
  // the samples on both sides by less than its curvature times the square of their distance/8.
  constexpr double kFineStep = 0.1e-3;
  const auto bend = [](const Profile::Sample& s) {
    return s.second / std::pow(1 + s.slope * s.slope, 1.5);
  };
  for (int i = 0; i < samples_; ++i) {
    double least = 1e9;
    double most = -1e9;
    double wheel_bend = 0;
    double arc = 0;
    for (double y = WheelY(i); y <= WheelY(i + 1); y += kFineStep) {
      const Profile::Sample s = wheel_.At(y);
      least = std::min(least, std::atan(s.slope) - kMostRoll);
      most = std::max(most, std::atan(s.slope) + kMostRoll);
      wheel_bend = std::max(wheel_bend, -bend(s));
      arc += kFineStep * std::sqrt(1 + s.slope * s.slope);
    }
    double rail_bend = 0;
    for (double y = rail_.min_y(); y <= rail_.max_y(); y += kFineStep) {
      const Profile::Sample s = rail_.At(y);
      if (std::atan(s.slope) >= least && std::atan(s.slope) <= most) {
        rail_bend = std::max(rail_bend, bend(s));
      }
    }
    margin_.push_back(kSpare * 0.125 * (wheel_bend + rail_bend) * arc * arc);
  }
}

double ContactSearch::DeepestNear(const Axle& axle, double low, double high) const noexcept {
  // The slopes of wheel and rail agree: false position that does not get stuck (Illinois).
  const auto difference = [&](double at) {
    const Locus l = LocusAt(axle, at);
    return l.slope - l.rail_slope;  // > 0: deeper further out
  };
  double f_low = difference(low);
  double f_high = difference(high);
  if (!(f_low > 0 && f_high < 0)) return 0.5 * (low + high);
  int side = 0;
  double at = low;
  for (int i = 0; i < 30; ++i) {
    const double next = (low * f_high - high * f_low) / (f_high - f_low);
    if (std::abs(next - at) < 1e-9) return next;
    at = next;
    const double f = difference(at);
    if (f > 0) {
      low = at;
      f_low = f;
      if (side == 1) f_high *= 0.5;
      side = 1;
    } else {
      high = at;
      f_high = f;
      if (side == -1) f_low *= 0.5;
      side = -1;
    }
  }
  return at;
}

void ContactSearch::FindHumps(const Axle& axle, const Samples& s, Humps* humps) const noexcept {
  for (int i = s.first; i <= s.last && humps->count < kMaxHumps; ++i) {
    if (s.depth[i] > 0) {
      int end = i;
      while (end < s.last && s.depth[end + 1] > 0) ++end;
      SplitRun(axle, s, i, end, humps);
      i = end;
      continue;
    }
    // A hump between two samples that both do not touch.
    if (i == s.last || s.depth[i + 1] > 0) continue;
    if (std::max(s.depth[i], s.depth[i + 1]) < -margin_[static_cast<size_t>(i)]) continue;
    AddBetween(axle, WheelY(i), WheelY(i + 1), humps);
  }
}

void ContactSearch::AddBetween(const Axle& axle, double low, double high,
                               Humps* humps) const noexcept {
  const auto rises = [&](double at) {
    const Locus l = LocusAt(axle, at);
    return l.slope > l.rail_slope;
  };
  if (!rises(low) || rises(high)) return;
  const double middle = DeepestNear(axle, low, high);
  if (!(LocusAt(axle, middle).overlap > 0)) return;
  Hump& h = humps->hump[humps->count++];
  h.begin = EdgeBetween(axle, middle, low, 0.5 * (middle + low));
  h.end = EdgeBetween(axle, middle, high, 0.5 * (middle + high));
  h.merge_next = 0;
  h.at_end = false;
}

void ContactSearch::SplitRun(const Axle& axle, const Samples& s, int begin, int end,
                             Humps* humps) const noexcept {
  // Ridges: local minima of the depth inside the run, with m of the humps beside them.
  struct Ridge {
    int sample;
    double merge;
  };
  Ridge ridge[kMaxRidges];
  int ridges = 0;
  const auto greatest = [&](int from, int to) {
    double depth = 0;
    for (int i = from; i <= to; ++i) depth = std::max(depth, s.depth[i]);
    return depth;
  };
  for (int i = begin + 1; i < end && ridges < kMaxRidges; ++i) {
    if (s.depth[i] <= s.depth[i - 1] && s.depth[i] < s.depth[i + 1]) ridge[ridges++] = {i, 0};
  }
  // Take out the ridge that separates least until the rest are true and few enough.
  for (;;) {
    int weakest = -1;
    for (int k = 0; k < ridges; ++k) {
      const int left = k == 0 ? begin : ridge[k - 1].sample;
      const int right = k + 1 == ridges ? end : ridge[k + 1].sample;
      const double shallower =
          std::min(greatest(left, ridge[k].sample), greatest(ridge[k].sample, right));
      ridge[k].merge = s.depth[ridge[k].sample] / shallower;
      if (weakest < 0 || ridge[k].merge > ridge[weakest].merge) weakest = k;
    }
    const bool room = humps->count + ridges + 1 <= kMaxHumps;
    if (weakest < 0 || (room && ridge[weakest].merge < kSameHump)) break;
    for (int k = weakest; k + 1 < ridges; ++k) ridge[k] = ridge[k + 1];
    --ridges;
  }
  const bool open_begin = begin == s.first;
  const bool open_end = end == s.last;
  double from = open_begin ? WheelY(begin) : EdgeOfRun(axle, s, begin, begin - 1);
  for (int k = 0; k <= ridges; ++k) {
    Hump& h = humps->hump[humps->count++];
    h.begin = from;
    h.merge_next = 0;
    h.at_end = (k == 0 && open_begin) || (k == ridges && open_end);
    if (k == ridges) {
      h.end = open_end ? WheelY(end) : EdgeOfRun(axle, s, end, end + 1);
    } else {
      const int i = ridge[k].sample;
      const double rise = s.depth[i + 1] - s.depth[i - 1];
      const double bend = s.depth[i + 1] + s.depth[i - 1] - 2 * s.depth[i];
      h.end = WheelY(i) - 0.5 * step_ * std::clamp(rise / bend, -1.0, 1.0);
      h.merge_next = SmoothStep(ridge[k].merge / kSameHump);
    }
    from = h.end;
  }
}

void ContactSearch::FindPoints(const WheelPlacement& wheel, double rail_y, double rail_z,
                               Overlaps* found) const noexcept {
  const Axle axle = PlaceAxle(wheel, rail_y, rail_z);
  Samples s;
  Sample(axle, &s);
  found->count = 0;
  for (int i = s.first; i <= s.last && found->count < kMaxHumps; ++i) {
    const bool left = i == s.first || s.depth[i] >= s.depth[i - 1];
    const bool right = i == s.last || s.depth[i] > s.depth[i + 1];
    if (!left || !right || !(s.depth[i] > 0)) continue;
    const bool inside = i > s.first && i < s.last;
    const double at = inside ? DeepestNear(axle, WheelY(i - 1), WheelY(i + 1)) : WheelY(i);
    const Locus l = LocusAt(axle, at);
    if (!(l.overlap > 0)) continue;
    Overlap& p = found->patch[static_cast<size_t>(found->count++)];
    p.wheel_y = at;
    p.y = l.y;
    p.z = l.z;
    p.slope = l.rail_slope;
    p.depth = l.overlap / std::sqrt(1 + l.rail_slope * l.rail_slope);
    p.radius = radius_ + wheel_.At(at).z;
    p.across = kUsual;
    const double push = bed_.At(l.y) * 4.0 / 3 * p.depth * std::sqrt(p.depth / p.across);
    p.push = {0, -push * p.slope, push};
    p.weight = 1;
  }
}

OverlapCentre ContactSearch::Centre(const WheelPlacement& wheel, double rail_y,
                                    double rail_z) const noexcept {
  constexpr double kFineStep = 0.02e-3;
  const Axle axle = PlaceAxle(wheel, rail_y, rail_z);
  OverlapCentre c;
  double sum = 0;
  for (double at = wheel_.min_y(); at < wheel_.max_y(); at += kFineStep) {
    const Locus l = LocusAt(axle, at);
    if (!(l.overlap > 0)) continue;
    const double weight = l.overlap * l.overlap * std::sqrt(l.overlap) * l.stretch;
    sum += weight;
    c.rail_y += weight * l.y;
    c.angle -= weight * std::atan(l.rail_slope);
    c.wheel_y += weight * at;
  }
  if (!(sum > 0)) return c;
  for (double* mean : {&c.rail_y, &c.angle, &c.wheel_y}) *mean /= sum;
  c.radius = radius_ + wheel_.At(c.wheel_y).z;
  c.found = true;
  return c;
}

}  // namespace phs::rail
