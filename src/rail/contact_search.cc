#include "rail/contact_search.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {
namespace {

constexpr int kMaxSamples = 192;
constexpr double kCoarseStep = 1.5e-3;  ///< [m]
/// A coarse minimum this far above the rail can still touch between the samples of a steep flank.
constexpr double kNear = 1.5e-3;
/// Curvature is that of the gap averaged over +- this arc length: contact patches are that wide,
/// and profiles of circular arcs have jumps of curvature that a patch does not feel.
constexpr double kHalfPatch = 3e-3;
/// Flattest relative curvature across: conformal regions carry a wide but finite patch.
constexpr double kFlattest = 0.25;

}  // namespace

ContactSearch::ContactSearch(Profile wheel, Profile rail, double half_tape, double radius)
    : wheel_(std::move(wheel)), rail_(std::move(rail)), half_tape_(half_tape), radius_(radius) {
  begin_ = wheel_.min_y();
  samples_ = std::min(kMaxSamples, static_cast<int>((wheel_.max_y() - begin_) / kCoarseStep) + 1);
  step_ = (wheel_.max_y() - begin_) / (samples_ - 1);
  for (int i = 0; i < samples_; ++i) sample_.push_back(wheel_.At(begin_ + step_ * i));
}

ContactSearch::Locus ContactSearch::LocusAt(const Axle& a, double wheel_y) const noexcept {
  return LocusOf(a, wheel_y, wheel_.At(wheel_y));
}

ContactSearch::Locus ContactSearch::LocusOf(const Axle& a, double wheel_y,
                                            const Profile::Sample& s) const noexcept {
  const double radius = radius_ + s.z;
  const double t = s.slope;
  const double along = half_tape_ + wheel_y;
  const double ux = t * a.ex;
  const double alpha = -t * a.ex * a.ex / a.q;
  const double side = t * a.ex / a.q;
  const double beta = std::sqrt(std::max(0.0, 1 - side * side));
  const double uy = (alpha * a.ey - beta * a.ez) / a.q;
  const double uz = (alpha * a.ez + beta * a.ey) / a.q;
  Locus l;
  l.arm = {a.ex * along + radius * ux, a.ey * along + radius * uy, a.ez * along + radius * uz};
  l.y = a.y + l.arm[1];
  l.z = a.z + l.arm[2];
  l.slope = -(uy - t * a.ey) / (uz - t * a.ez);
  l.radius = radius;
  return l;
}

double ContactSearch::GapAt(const Axle& axle, double wheel_y) const noexcept {
  const Locus l = LocusAt(axle, wheel_y);
  return rail_.At(l.y).z - l.z;
}

double ContactSearch::SlopeDifference(const Axle& axle, double wheel_y) const noexcept {
  const Locus l = LocusAt(axle, wheel_y);
  return rail_.At(l.y).slope - l.slope;
}

double ContactSearch::Agree(const Axle& axle, double low, double high, double f_low,
                            double f_high) const noexcept {
  // Illinois: false position that does not get stuck; ends at rounding.
  int last = 0;
  for (int i = 0; i < 40; ++i) {
    double at = (low * f_high - high * f_low) / (f_high - f_low);
    if (!(at > low && at < high)) at = 0.5 * (low + high);
    const double f = SlopeDifference(axle, at);
    if (f == 0 || high - low < 1e-13) return at;
    if ((f > 0) == (f_high > 0)) {
      if (std::abs(at - high) < 1e-14) return at;
      high = at;
      f_high = f;
      if (last == 1) f_low *= 0.5;
      last = 1;
    } else {
      if (std::abs(at - low) < 1e-14) return at;
      low = at;
      f_low = f;
      if (last == -1) f_high *= 0.5;
      last = -1;
    }
    if (std::abs(f) < 1e-13) return at;
  }
  return 0.5 * (low + high);
}

TouchingPoint ContactSearch::Describe(const Axle& axle, double wheel_y) const noexcept {
  const Locus l = LocusAt(axle, wheel_y);
  const Profile::Sample r = rail_.At(l.y);
  TouchingPoint p;
  p.wheel_y = wheel_y;
  p.y = l.y;
  p.z = l.z;
  p.arm = l.arm;
  p.slope = 0.5 * (r.slope + l.slope);
  const double cosine = 1 / std::sqrt(1 + p.slope * p.slope);
  const double gap = r.z - l.z;
  p.depth = -gap * cosine;
  p.radius = l.radius;
  // Second difference of the normal gap over the width of a patch, measured along the surface.
  const double dy = kHalfPatch * cosine;
  const double ahead = GapAt(axle, wheel_y + dy);
  const double behind = GapAt(axle, wheel_y - dy);
  const double bend = (ahead + behind - 2 * gap) * cosine / (kHalfPatch * kHalfPatch);
  p.across = std::max(0.5 * bend, kFlattest);
  constexpr double kEnd = 0.5e-3;
  p.at_end = wheel_y < wheel_.min_y() + kEnd || wheel_y > wheel_.max_y() - kEnd ||
             l.y < rail_.min_y() + kEnd || l.y > rail_.max_y() - kEnd;
  return p;
}

TouchingPoints ContactSearch::Find(const WheelPlacement& wheel, double rail_y,
                                   double rail_z) const noexcept {
  Axle a{};
  a.ex = -std::sin(wheel.yaw) * std::cos(wheel.roll);
  a.ey = std::cos(wheel.yaw) * std::cos(wheel.roll);
  a.ez = std::sin(wheel.roll);
  a.q = std::sqrt(1 - a.ex * a.ex);
  a.y = wheel.y - rail_y;
  a.z = wheel.z - rail_z;

  // Only the part of the wheel that lies over the rail.
  const double centre = a.y + half_tape_;
  const double over_begin = rail_.min_y() - centre;
  const double over_end = rail_.max_y() - centre;
  const int first = std::clamp(static_cast<int>((over_begin - begin_) / step_), 0, samples_ - 1);
  const int last = std::clamp(static_cast<int>((over_end - begin_) / step_) + 1, 0, samples_ - 1);
  double gap[kMaxSamples];
  for (int i = first; i <= last; ++i) {
    const Locus l = LocusOf(a, begin_ + step_ * i, sample_[static_cast<size_t>(i)]);
    gap[i] = rail_.At(l.y).z - l.z;
  }

  TouchingPoints found;
  int at_sample[kMaxMinima];
  for (int i = first; i <= last; ++i) {
    const bool left = i == first || gap[i] <= gap[i - 1];
    const bool right = i == last || gap[i] < gap[i + 1];
    if (!left || !right || gap[i] > kNear) continue;
    const double low = begin_ + step_ * std::max(i - 1, first);
    const double high = begin_ + step_ * std::min(i + 1, last);
    const double f_low = SlopeDifference(a, low);
    const double f_high = SlopeDifference(a, high);
    const double position =
        f_low < 0 && f_high > 0 ? Agree(a, low, high, f_low, f_high) : begin_ + step_ * i;
    TouchingPoint point = Describe(a, position);
    if (!(point.depth > 0)) continue;
    if (found.count == kMaxMinima) break;
    at_sample[found.count] = i;
    found.point[static_cast<size_t>(found.count++)] = point;
  }

  // Neighbours whose common ridge penetrates too are one patch growing out of two: each carries its
  // Hertz force reduced so that the sum stays continuous while a minimum appears or vanishes.
  for (int k = 0; k + 1 < found.count; ++k) {
    TouchingPoint& p = found.point[static_cast<size_t>(k)];
    TouchingPoint& n = found.point[static_cast<size_t>(k) + 1];
    int top = at_sample[k];
    for (int i = at_sample[k]; i <= at_sample[k + 1]; ++i) {
      if (gap[i] > gap[top]) top = i;
    }
    if (gap[top] >= 0) continue;
    const double cosine = 1 / std::sqrt(1 + 0.25 * (p.slope + n.slope) * (p.slope + n.slope));
    const double ridge = -gap[top] * cosine;
    const double rise_p = std::max(p.depth - ridge, 0.0);
    const double rise_n = std::max(n.depth - ridge, 0.0);
    const double separate = std::min(rise_p, rise_n) / std::min(p.depth, n.depth);
    const double sum = std::max(rise_p + rise_n, 1e-15);
    p.weight *= separate + (1 - separate) * rise_p / sum;
    n.weight *= separate + (1 - separate) * rise_n / sum;
  }
  return found;
}

}  // namespace phs::rail
