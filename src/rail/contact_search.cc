#include "rail/contact_search.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {
namespace {

constexpr double kWheelStep = 1.2e-3;   ///< of the samples [m]
constexpr double kRailStep = 0.125e-3;  ///< of the table for the samples [m]
/// A hump between samples rises above them by less than B step^2/4; B = 1/(12 mm) at most.
constexpr double kNear = 0.1e-3;
/// Humps whose ridge is this near to the shallower one are one hump.
constexpr double kSameHump = 0.98;
constexpr int kMaxRidges = 12;

/// Ten-point Gauss-Legendre rule on [-1, 1].
constexpr double kNode[] = {-0.9739065285171717, -0.8650633666889845, -0.6794095682990244,
                            -0.4333953941292472, -0.1488743389816312, 0.1488743389816312,
                            0.4333953941292472,  0.6794095682990244,  0.8650633666889845,
                            0.9739065285171717};
constexpr double kWeight[] = {0.0666713443086881, 0.1494513491505806, 0.2190863625159820,
                              0.2692667193099964, 0.2955242247147529, 0.2955242247147529,
                              0.2692667193099964, 0.2190863625159820, 0.1494513491505806,
                              0.0666713443086881};

/// 0 at 0, 1 at 1, level at both.
double SmoothStep(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// beta = sqrt(1 - x^2); |x| <= 0.3 for slopes up to 6 and yaw up to 50 mrad, error below 1e-9.
double RootOfRest(double square) {
  if (square > 0.02) return std::sqrt(std::max(0.0, 1 - square));
  return 1 - square * (0.5 + square * (0.125 + square * (0.0625 + square * (5.0 / 128))));
}

}  // namespace

ContactSearch::ContactSearch(Profile wheel, Profile rail, double half_tape, double radius)
    : wheel_(std::move(wheel)), rail_(std::move(rail)), half_tape_(half_tape), radius_(radius) {
  const double width = wheel_.max_y() - wheel_.min_y();
  begin_ = wheel_.min_y();
  samples_ = std::clamp(static_cast<int>(std::ceil(width / kWheelStep)) + 1, 2, kMaxSamples);
  step_ = width / (samples_ - 1);
  for (int i = 0; i < samples_; ++i) {
    const Profile::Sample s = wheel_.At(WheelY(i));
    const double r = radius_ + s.z;
    radius_at_.push_back(r);
    radius_slope_.push_back(r * s.slope);
    radius_square_.push_back(0.5 * r * s.slope * s.slope);
    cosine_at_.push_back(1 / std::sqrt(1 + s.slope * s.slope));
  }
  const double rail_width = rail_.max_y() - rail_.min_y();
  const int pieces = static_cast<int>(std::ceil(rail_width / kRailStep));
  rail_begin_ = rail_.min_y();
  rail_per_step_ = pieces / rail_width;
  for (int i = 0; i <= pieces; ++i) rail_z_.push_back(rail_.At(rail_begin_ + i / rail_per_step_).z);
  rail_z_.push_back(rail_z_.back());
}

ContactSearch::Axle ContactSearch::PlaceAxle(const WheelPlacement& wheel, double rail_y,
                                             double rail_z) const noexcept {
  Axle a{};
  a.ex = -std::sin(wheel.yaw) * std::cos(wheel.roll);
  a.ey = std::cos(wheel.yaw) * std::cos(wheel.roll);
  a.ez = std::sin(wheel.roll);
  const double q2 = 1 - a.ex * a.ex;
  const double q = std::sqrt(q2);
  a.side = a.ex / q;
  a.alpha_y = a.ex * a.ex / q2 * a.ey;
  a.alpha_z = a.ex * a.ex / q2 * a.ez;
  a.beta_y = -a.ez / q;
  a.beta_z = a.ey / q;
  a.y = wheel.y - rail_y;
  a.z = wheel.z - rail_z;
  return a;
}

ContactSearch::Locus ContactSearch::LocusAt(const Axle& a, double wheel_y) const noexcept {
  const Profile::Sample s = wheel_.At(wheel_y);
  const double radius = radius_ + s.z;
  const double t = s.slope;
  const double along = half_tape_ + wheel_y;
  const double beta = RootOfRest(t * t * a.side * a.side);
  const double uy = beta * a.beta_y - t * a.alpha_y;
  const double uz = beta * a.beta_z - t * a.alpha_z;
  Locus l;
  l.y = a.y + a.ey * along + radius * uy;
  l.z = a.z + a.ez * along + radius * uz;
  l.slope = -(uy - t * a.ey) / (uz - t * a.ez);
  l.stretch =
      a.ey + t * uy - radius * s.second * (a.alpha_y + t * a.side * a.side / beta * a.beta_y);
  const Profile::Sample r = rail_.At(l.y);
  l.rail_slope = r.slope;
  l.overlap = l.z - r.z;
  return l;
}

void ContactSearch::Sample(const Axle& a, Samples* samples) const noexcept {
  // Only the part of the wheel that lies over the rail.
  const double centre = a.y + half_tape_ * a.ey + radius_ * a.beta_y;
  const int last = samples_ - 1;
  samples->first =
      std::clamp(static_cast<int>((rail_.min_y() - centre - begin_) / step_) + 1, 0, last);
  samples->last = std::clamp(static_cast<int>((rail_.max_y() - centre - begin_) / step_), 0, last);
  // y and z of the locus with beta = 1 - t^2 side^2/2; place in the rail's table.
  const double side = a.side * a.side;
  const double rail_end = static_cast<double>(rail_z_.size() - 2) - 1e-9;
  const double y0 = (a.y + a.ey * (half_tape_ + begin_) - rail_begin_) * rail_per_step_;
  const double y1 = a.ey * step_ * rail_per_step_;
  const double y2 = a.beta_y * rail_per_step_;
  const double y3 = a.alpha_y * rail_per_step_;
  const double z0 = a.z + a.ez * (half_tape_ + begin_);
  const double z1 = a.ez * step_;
  double place[kMaxSamples];
  double z[kMaxSamples];
  const int first = samples->first;
  const int end = samples->last + 1;
  for (int i = first; i < end; ++i) {
    const double down = radius_at_[i] - side * radius_square_[i];
    const double at = y0 + y1 * i + y2 * down - y3 * radius_slope_[i];
    place[i] = std::min(std::max(at, 0.0), rail_end);
    z[i] = z0 + z1 * i + a.beta_z * down - a.alpha_z * radius_slope_[i];
  }
  for (int i = first; i < end; ++i) {
    const int j = static_cast<int>(place[i]);
    const double below = rail_z_[j];
    const double rail_z = below + (place[i] - j) * (rail_z_[j + 1] - below);
    samples->depth[i] = (z[i] - rail_z) * cosine_at_[i];
  }
}

double ContactSearch::EdgeBetween(const Axle& axle, double inside, double outside,
                                  double at) const noexcept {
  // Newton on the overlap, kept between the ends; the integrals feel its error squared.
  double low = std::min(inside, outside);
  double high = std::max(inside, outside);
  const bool outwards = outside > inside;
  for (int i = 0; i < 40; ++i) {
    const Locus l = LocusAt(axle, at);
    ((l.overlap > 0) == outwards ? low : high) = at;
    double next = at - l.overlap / ((l.slope - l.rail_slope) * l.stretch);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - at);
    at = next;
    if (step < 1e-6) break;
  }
  return at;
}

double ContactSearch::EdgeOfRun(const Axle& axle, const Samples& s, int sample,
                                int next) const noexcept {
  const double share = s.depth[sample] / (s.depth[sample] - s.depth[next]);
  const double inside = WheelY(sample);
  const double outside = WheelY(next);
  return EdgeBetween(axle, inside, outside, inside + share * (outside - inside));
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
    // A hump between samples: this one is nearest and does not quite touch.
    const bool inside = i > s.first && i < s.last;
    if (!inside || s.depth[i] < -kNear || s.depth[i - 1] > s.depth[i] ||
        s.depth[i + 1] >= s.depth[i]) {
      continue;
    }
    const double middle = DeepestNear(axle, WheelY(i - 1), WheelY(i + 1));
    const Locus l = LocusAt(axle, middle);
    if (!(l.overlap > 0)) continue;
    Hump& h = humps->hump[humps->count++];
    h.begin = EdgeBetween(axle, middle, WheelY(i - 1), 0.5 * (middle + WheelY(i - 1)));
    h.end = EdgeBetween(axle, middle, WheelY(i + 1), 0.5 * (middle + WheelY(i + 1)));
    h.depth = l.overlap;
    h.merge_next = 0;
    h.at_end = false;
  }
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

void ContactSearch::Moments::Add(const Moments& m) {
  i += m.i;
  wheel += m.wheel;
  y += m.y;
  z += m.z;
  yy += m.yy;
  yz += m.yz;
  zz += m.zz;
  ny += m.ny;
  nz += m.nz;
}

ContactSearch::Moments ContactSearch::Integrate(const Axle& a, const Hump& hump) const noexcept {
  const double middle = 0.5 * (hump.begin + hump.end);
  const double half = 0.5 * (hump.end - hump.begin);
  // Pass by pass, so that the arithmetic between the look-ups is done two nodes at a time.
  double at[kNodes], radius[kNodes], slope[kNodes], second[kNodes];
  double y[kNodes], z[kNodes], dy[kNodes], rail_z[kNodes], rail_slope[kNodes];
  for (int k = 0; k < kNodes; ++k) {
    at[k] = middle + half * kNode[k];
    const Profile::Sample s = wheel_.At(at[k]);
    radius[k] = radius_ + s.z;
    slope[k] = s.slope;
    second[k] = s.second;
  }
  const double side = a.side * a.side;
  for (int k = 0; k < kNodes; ++k) {
    const double t = slope[k];
    const double along = half_tape_ + at[k];
    const double square = t * t * side;
    const double beta = 1 - square * (0.5 + square * (0.125 + square * 0.0625));
    const double uy = beta * a.beta_y - t * a.alpha_y;
    const double uz = beta * a.beta_z - t * a.alpha_z;
    y[k] = a.y + a.ey * along + radius[k] * uy;
    z[k] = a.z + a.ez * along + radius[k] * uz;
    slope[k] = -(uy - t * a.ey) / (uz - t * a.ez);
    dy[k] = a.ey + t * uy - radius[k] * second[k] * (a.alpha_y + t * side * a.beta_y);
  }
  for (int k = 0; k < kNodes; ++k) {
    const Profile::Sample r = rail_.At(y[k]);
    rail_z[k] = r.z;
    rail_slope[k] = r.slope;
  }
  Moments m;
  for (int k = 0; k < kNodes; ++k) {
    const double h = std::max(z[k] - rail_z[k], 0.0) * dy[k] * half * kWeight[k];
    const double mean = 0.5 * (slope[k] + rail_slope[k]);
    const double part = h / std::sqrt(1 + mean * mean);
    m.i += h;
    m.wheel += h * at[k];
    m.y += h * y[k];
    m.z += h * z[k];
    m.yy += h * y[k] * y[k];
    m.yz += h * y[k] * z[k];
    m.zz += h * z[k] * z[k];
    m.ny -= part * mean;
    m.nz += part;
  }
  return m;
}

void ContactSearch::Describe(const Axle& a, const Moments& m, Overlap* patch) const noexcept {
  Overlap& p = *patch;
  const double inverse = 1 / m.i;
  p.wheel_y = m.wheel * inverse;
  const Profile::Sample s = wheel_.At(p.wheel_y);
  p.radius = radius_ + s.z;
  const double t = s.slope;
  const double along = half_tape_ + p.wheel_y;
  const double beta = RootOfRest(t * t * a.side * a.side);
  p.arm = {a.ex * along + p.radius * t * a.ex,
           a.ey * along + p.radius * (beta * a.beta_y - t * a.alpha_y),
           a.ez * along + p.radius * (beta * a.beta_z - t * a.alpha_z)};
  p.y = a.y + p.arm[1];
  p.z = a.z + p.arm[2];
  p.slope = -m.ny / m.nz;
  // Variance along the tangent (1, slope)/sqrt(1 + slope^2).
  const double y = m.y * inverse;
  const double z = m.z * inverse;
  const double vyy = m.yy * inverse - y * y;
  const double vyz = m.yz * inverse - y * z;
  const double vzz = m.zz * inverse - z * z;
  const double along_tangent =
      (vyy + p.slope * (2 * vyz + p.slope * vzz)) / (1 + p.slope * p.slope);
  const double half_width = std::sqrt(5 * std::max(along_tangent, 1e-14));
  p.depth = 0.75 * m.i / half_width;
  p.across = p.depth / (half_width * half_width);
}

void ContactSearch::Find(const WheelPlacement& wheel, double rail_y, double rail_z,
                         Overlaps* found) const noexcept {
  const Axle axle = PlaceAxle(wheel, rail_y, rail_z);
  Samples samples;
  Sample(axle, &samples);
  Humps humps;
  FindHumps(axle, samples, &humps);
  found->count = 0;
  found->axle = {axle.ex, axle.ey, axle.ez};
  Moments moments[kMaxHumps];
  for (int k = 0; k < humps.count; ++k) moments[k] = Integrate(axle, humps.hump[k]);
  // Every way of reading neighbours as one patch, with its weight.
  for (int from = 0; from < humps.count; ++from) {
    Moments sum;
    double weight = from > 0 ? 1 - humps.hump[from - 1].merge_next : 1;
    bool at_end = false;
    for (int to = from; to < humps.count && weight > 0; ++to) {
      sum.Add(moments[to]);
      at_end = at_end || humps.hump[to].at_end;
      const double merge = humps.hump[to].merge_next;
      const double share = weight * (1 - merge);
      weight *= merge;
      if (!(share > 0) || !(sum.i > 0)) continue;
      Overlap& patch = found->patch[static_cast<size_t>(found->count++)];
      Describe(axle, sum, &patch);
      patch.weight = share;
      patch.at_end = at_end;
    }
  }
}

}  // namespace phs::rail
