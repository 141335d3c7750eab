// The humps of the overlap: where they are, how far they have grown together, their deepest points.
#include <algorithm>
#include <cmath>

#include "rail/contact_search.h"

namespace phs::rail {
namespace {

constexpr double kSpare = 1.25;     ///< a yawed wheel is more curved across
constexpr double kMostRoll = 0.06;  ///< and other differences of slope at a contact [rad]
/// Humps of samples nearer to each other (a of contact_search.h) are not looked at.
constexpr double kSameHump = 1e-4;
constexpr double kPlace = 3e-6;  ///< a last step, which leaves much less [m]
constexpr int kNewtons = 6;
constexpr int kMaxRidges = 12;
constexpr double kUsual = 3;  ///< relative curvature across of a first guess [1/m]

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
    for (double y = WheelY(2 * i); y <= WheelY(2 * std::min(i + 1, samples_ - 1)); y += kFineStep) {
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
  most_margin_ = *std::max_element(margin_.begin(), margin_.end());
}

ContactSearch::Locus ContactSearch::StationaryNear(const Axle& axle, const Samples& s, int sample,
                                                   double sign, double* place) const noexcept {
  sample = std::clamp(sample, 2 * s.first + 1, 2 * s.last - 1);
  const double low = WheelY(sample - 1);
  const double high = WheelY(sample + 1);
  // From the top of the parabola through three samples by Newton's steps.
  const double before = Vertical(s, sample - 1), after = Vertical(s, sample + 1);
  const double bend = before - 2 * Vertical(s, sample) + after;
  double at = WheelY(sample) - 0.25 * (high - low) * (after - before) / bend;
  if (!(at > low && at < high && sign * bend < 0)) at = WheelY(sample);
  for (int i = 0; i < kNewtons && at > low && at < high; ++i) {
    Locus l = LocusAt(axle, at);
    const double difference = l.slope - l.rail_slope;
    const double change = l.wheel_bend - l.rail_bend;
    if (!(sign * change < 0)) break;
    const double step = -difference / change;
    at += step;
    if (std::abs(step) > kPlace) continue;
    // Of the last step only the overlap is taken along: a point of the locus does no work on spin.
    *place = at;
    l.overlap += 0.5 * difference * l.stretch * step;
    return l;
  }
  *place = StationaryBetween(axle, low, high, sign);
  return LocusAt(axle, *place);
}

double ContactSearch::StationaryBetween(const Axle& axle, double low, double high,
                                        double sign) const noexcept {
  // The slopes of wheel and rail agree. By halves: beside a steep end of the rail nothing else is sure.
  const auto deeper = [&](double at) {
    const Locus l = LocusAt(axle, at);
    return sign * (l.slope - l.rail_slope) > 0;  // further out
  };
  if (!deeper(low) || deeper(high)) return 0.5 * (low + high);
  while (high - low > kPlace) {
    const double middle = 0.5 * (low + high);
    (deeper(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void ContactSearch::FindHumps(const Axle& axle, Samples* samples, Humps* humps) const noexcept {
  const Samples& s = *samples;
  int near = s.first;  // the next sample that may have to do with a hump
  for (int i = s.first; i <= s.last && humps->count < kMaxHumps; ++i) {
    while (near <= s.last && (near < i || s.coarse[near] < -most_margin_)) ++near;
    i = std::max(i, near - 1);
    if (s.coarse[i] > 0) {
      int end = i;
      while (end < s.last && s.coarse[end + 1] > 0) ++end;
      AddRun(axle, i, end, samples, humps);
      i = end;
      continue;
    }
    // A hump between two samples that both do not touch.
    if (i == s.last || s.coarse[i + 1] > 0) continue;
    if (std::max(s.coarse[i], s.coarse[i + 1]) < -margin_[static_cast<size_t>(i)]) continue;
    AddBetween(axle, i, humps);
  }
  for (int k = 0; k + 1 < humps->count; ++k) {
    Link(axle, samples, &humps->hump[k], &humps->hump[k + 1]);
  }
}

void ContactSearch::AddRun(const Axle& axle, int begin, int end, Samples* s,
                           Humps* humps) const noexcept {
  SampleMiddles(axle, begin - 1, end + 1, s);
  int from = 2 * begin;
  int to = 2 * end;
  if (begin > s->first && s->At(from - 1) > 0) --from;
  if (end < s->last && s->At(to + 1) > 0) ++to;
  for (int i = from; i <= to && humps->count < kMaxHumps; ++i) {
    if (!(s->At(i) > 0)) continue;
    const int first = i;
    while (i < to && s->At(i + 1) > 0) ++i;
    SplitRun(*s, first, i, humps);
  }
}

void ContactSearch::AddBetween(const Axle& axle, int coarse, Humps* humps) const noexcept {
  const double low = WheelY(2 * coarse), high = WheelY(2 * coarse + 2);
  const auto rises = [&](double at) {
    const Locus l = LocusAt(axle, at);
    return l.slope > l.rail_slope;
  };
  if (!rises(low) || rises(high)) return;
  const double middle = StationaryBetween(axle, low, high);
  const double depth = LocusAt(axle, middle).overlap;
  if (!(depth > 0)) return;
  Hump& h = humps->hump[humps->count++];
  h.top = middle;
  h.depth = depth;
  h.sample = -1;
  h.beside = 2 * coarse;
  h.joined = h.after = false;
  h.begin = low;
  h.end = high;
  h.next.m = 0;
  h.at_end = false;
}

void ContactSearch::SplitRun(const Samples& s, int begin, int end, Humps* humps) const noexcept {
  // Ridges: local minima of the overlap inside the run. Before, between and after them the tops.
  int ridge[kMaxRidges], top[kMaxRidges + 1];
  int ridges = 0;
  double heights[2 * kMaxSamples];
  for (int k = (begin + 1) / 2; 2 * k <= end; ++k) {
    heights[2 * k - begin] = s.coarse[k] * coarse_.stretch[static_cast<size_t>(k)];
  }
  for (int k = begin / 2; 2 * k + 1 <= end; ++k) {
    heights[2 * k + 1 - begin] = s.middle[k] * middle_.stretch[static_cast<size_t>(k)];
  }
  const auto overlap = [&](int i) { return heights[i - begin]; };
  double before = 0, here = overlap(begin), most = here;
  top[0] = begin;
  for (int i = begin; i <= end; ++i) {
    const double after = i < end ? overlap(i + 1) : 0;
    if (here > most) {
      most = here;
      top[ridges] = i;
    }
    if (i > begin && i < end && here <= before && here < after && ridges < kMaxRidges) {
      ridge[ridges++] = i;
      top[ridges] = i;
      most = here;
    }
    before = here;
    here = after;
  }
  // Take out the ridge that separates least until the rest are true and few enough.
  for (;;) {
    int weakest = -1;
    double least = 1;
    for (int k = 0; k < ridges; ++k) {
      const double between = overlap(ridge[k]);
      const double apart = (1 - between / overlap(top[k])) * (1 - between / overlap(top[k + 1]));
      if (weakest >= 0 && apart >= least) continue;
      weakest = k;
      least = apart;
    }
    const bool room = humps->count + ridges + 1 <= kMaxHumps;
    if (weakest < 0 || (room && least > kSameHump)) break;
    if (overlap(top[weakest + 1]) > overlap(top[weakest])) top[weakest] = top[weakest + 1];
    std::copy(ridge + weakest + 1, ridge + ridges, ridge + weakest);
    std::copy(top + weakest + 2, top + ridges + 1, top + weakest + 1);
    --ridges;
  }
  const bool open_begin = begin == 2 * s.first;
  const bool open_end = end == 2 * s.last;
  for (int k = 0; k <= ridges; ++k) {
    const bool first = k == 0, last = k == ridges;
    const int low = first ? begin : ridge[k - 1];
    const int high = last ? end : ridge[k];
    Hump& h = humps->hump[humps->count++];
    h.sample = top[k];
    h.top = WheelY(h.sample);
    h.depth = overlap(h.sample);
    h.begin = WheelY(first && !open_begin ? low - 1 : low);
    h.end = WheelY(last && !open_end ? high + 1 : high);
    h.joined = !last;
    h.after = !first;
    h.at_end = (first && open_begin) || (last && open_end);
    h.next.m = 0;
  }
}

void ContactSearch::FindPoints(const WheelPlacement& wheel, double rail_y, double rail_z,
                               Depth measure, Overlaps* found) const noexcept {
  const Axle axle = PlaceAxle(wheel, rail_y, rail_z);
  Samples s;
  Sample(axle, &s);
  SampleMiddles(axle, s.first, s.last, &s);
  found->count = 0;
  const auto depth = [&](int i) { return measure == Depth::kVertical ? Vertical(s, i) : s.At(i); };
  // The deepest local maxima, in their order on the wheel.
  int top[kMaxHumps];
  int tops = 0;
  const int first = 2 * s.first, last = 2 * s.last;
  for (int i = first; i <= last; ++i) {
    const bool left = i == first || depth(i) >= depth(i - 1);
    const bool right = i == last || depth(i) > depth(i + 1);
    if (!left || !right || !(s.At(i) > 0)) continue;
    if (tops == kMaxHumps) {
      int* least =
          std::min_element(top, top + tops, [&](int a, int b) { return depth(a) < depth(b); });
      if (depth(i) <= depth(*least)) continue;
      std::copy(least + 1, top + tops, least);
      --tops;
    }
    top[tops++] = i;
  }
  for (int k = 0; k < tops; ++k) {
    const int i = top[k];
    const bool inside = i > first && i < last;
    double at = WheelY(i);
    const Locus l = inside ? StationaryNear(axle, s, i, 1, &at) : LocusAt(axle, at);
    if (!(l.overlap > 0)) continue;
    Overlap& p = found->patch[static_cast<size_t>(found->count++)];
    p.wheel_y = at;
    p.y = l.y;
    p.z = l.z;
    p.slope = l.rail_slope;
    p.depth = l.overlap / std::sqrt(1 + l.rail_slope * l.rail_slope);
    p.radius = radius_ + wheel_.At(at).z;
    p.across = kUsual;
    // Hertz's k of the modulus there (contact_modulus.h).
    const double stiffness =
        2.5 * std::pow(modulus_.At(l.y) * kParabolaFourth / std::sqrt(p.across), 5.0 / 9);
    const double push = stiffness * p.depth * std::sqrt(p.depth);
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
