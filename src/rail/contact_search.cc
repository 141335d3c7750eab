#include "rail/contact_search.h"

#include <algorithm>
#include <cmath>

namespace phs::rail {
namespace {

constexpr double kWheelStep = 1.2e-3;  ///< of the samples [m]
constexpr double kRailStep = 0.125e-3;
constexpr double kBeyond = 2;       ///< samples beyond the ends of the rail
constexpr double kEnd = 0.5e-3;     ///< contact this near to an end is at the end [m]
constexpr int kPieces = 8;          ///< of a hump's overlap, as a polyline
constexpr double kEdge = 1e-5;      ///< the strips feel hardly anything of the edge [m]
constexpr double kSlack = 0.03e-3;  ///< [m]
constexpr double kAlmost = 1e-6;    ///< gap where samples are looked at again [m]
constexpr double kUsual = 3;        ///< relative curvature across of a first guess [1/m]
constexpr double kMostRoll = 0.06;  ///< and other differences of slope at a contact [rad]
/// b of a parabola by the fifth power of its load; the strips spread an ellipse by 3 %.
constexpr double kPeak = 0.97 * 0.64708;
constexpr double kBlend = 0.7;      ///< ridge from which two humps are also pressed as one
constexpr double kSameHump = 0.98;  ///< ridge of humps that are one

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

ContactSearch::ContactSearch(Profile wheel, Profile rail, double half_tape, double radius,
                             const Hertz& hertz)
    : wheel_(std::move(wheel)),
      rail_(std::move(rail)),
      half_tape_(half_tape),
      radius_(radius),
      hertz_(hertz),
      strips_(wheel_, rail_, radius, hertz.modulus()),
      usual_(hertz.AtApproach(1, 0.5 / radius, kUsual).normal) {
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
  MeasureMargins();
  const double rail_width = rail_.max_y() - rail_.min_y();
  const int pieces = static_cast<int>(std::ceil(rail_width / kRailStep));
  rail_begin_ = rail_.min_y();
  rail_per_step_ = pieces / rail_width;
  for (int i = 0; i <= pieces; ++i) rail_z_.push_back(rail_.At(rail_begin_ + i / rail_per_step_).z);
  rail_z_.push_back(2 * rail_z_.back() - rail_z_[rail_z_.size() - 2]);
}

void ContactSearch::MeasureMargins() {
  // A hump between samples has equal slopes on wheel and rail, but for the roll.
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
    margin_.push_back(0.125 * (wheel_bend + rail_bend) * arc * arc);
  }
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

double ContactSearch::RoughOverlapAt(const Axle& a, double wheel_y) const noexcept {
  const Profile::Sample s = wheel_.At(wheel_y);
  const double along = half_tape_ + wheel_y;
  const double square = s.slope * s.slope * a.side * a.side;
  const double beta = 1 - square * (0.5 + 0.125 * square);
  const double radius = radius_ + s.z;
  const double y = a.y + a.ey * along + radius * (beta * a.beta_y - s.slope * a.alpha_y);
  const double z = a.z + a.ez * along + radius * (beta * a.beta_z - s.slope * a.alpha_z);
  const double place = (y - rail_begin_) * rail_per_step_;
  const double rail_end = static_cast<double>(rail_z_.size() - 2);
  const auto k = static_cast<size_t>(std::min(std::max(place, 0.0), rail_end));
  return z - rail_z_[k] - (place - static_cast<double>(k)) * (rail_z_[k + 1] - rail_z_[k]);
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
  l.x = a.ex * (along + radius * t);
  l.y = a.y + a.ey * along + radius * uy;
  l.z = a.z + a.ez * along + radius * uz;
  l.slope = -(uy - t * a.ey) / (uz - t * a.ez);
  l.stretch =
      a.ey + t * uy - radius * s.second * (a.alpha_y + t * a.side * a.side / beta * a.beta_y);
  const Profile::Sample r = rail_.At(l.y);
  l.rail_slope = r.slope;
  l.overlap = l.z - r.z;
  l.radius = radius;
  l.wheel_slope = t;
  return l;
}

void ContactSearch::Sample(const Axle& a, Samples* samples) const noexcept {
  // Only the part of the wheel that lies over the rail, and kBeyond samples more.
  const double centre = a.y + half_tape_ * a.ey + radius_ * a.beta_y;
  const double from = (rail_.min_y() - centre - begin_) / step_ - kBeyond;
  const double to = (rail_.max_y() - centre - begin_) / step_ + kBeyond;
  samples->first = 0;
  samples->last = -1;
  if (!(from < samples_ - 1 && to > 0)) return;  // not a number, or far away
  samples->first = static_cast<int>(std::max(from, 0.0));
  samples->last = static_cast<int>(std::min(to, samples_ - 1.0));
  // y and z of the locus with beta = 1 - t^2 side^2/2; place in the rail's table.
  const double side = a.side * a.side;
  const double rail_end = static_cast<double>(rail_z_.size() - 2);
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
    place[i] = at;
    z[i] = z0 + z1 * i + a.beta_z * down - a.alpha_z * radius_slope_[i];
  }
  for (int i = first; i < end; ++i) {
    // Beyond the ends the rail goes on straight, as its profile does.
    const int j = static_cast<int>(std::min(std::max(place[i], 0.0), rail_end));
    const double below = rail_z_[j];
    const double rail_z = below + (place[i] - j) * (rail_z_[j + 1] - below);
    samples->depth[i] = (z[i] - rail_z) * cosine_at_[i];
  }
}

double ContactSearch::EdgeBetween(const Axle& axle, double inside, double outside,
                                  double at) const noexcept {
  // Newton on the overlap, kept between the ends; the integrals feel its error squared.
  // The samples' rail is a polyline: the edge may lie a little inside of `inside`.
  double low = std::min(inside, outside) - kSlack;
  double high = std::max(inside, outside) + kSlack;
  const bool outwards = outside > inside;
  for (int i = 0; i < 40; ++i) {
    const Locus l = LocusAt(axle, at);
    ((l.overlap > 0) == outwards ? low : high) = at;
    double next = at - l.overlap / ((l.slope - l.rail_slope) * l.stretch);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - at);
    at = next;
    if (step < kEdge) break;
  }
  return at;
}

double ContactSearch::EdgeOfRun(const Axle& axle, const Samples& s, int sample,
                                int next) const noexcept {
  const double share = s.depth[sample] / (s.depth[sample] - s.depth[next]);
  const double inside = WheelY(sample);
  double outside = WheelY(next);
  // The polyline of the samples may say no where the rail itself just touches: then the edge lies
  // before the lowest place between them.
  if (s.depth[next] > -kAlmost && LocusAt(axle, outside).overlap > 0) {
    const double beyond = outside + (outside - inside);
    outside = outside > inside ? DeepestNear(axle, inside, beyond, -1)
                               : DeepestNear(axle, beyond, inside, -1);
    return EdgeBetween(axle, inside, outside, 0.5 * (inside + outside));
  }
  return EdgeBetween(axle, inside, outside, inside + share * (outside - inside));
}

void ContactSearch::AddStrips(const Axle& axle, const Hump& hump,
                              StripLoads* strips) const noexcept {
  // Strips of equal area of overlap: a flat shoulder that begins to overlap moves none of them.
  const double step = (hump.end - hump.begin) / kPieces;
  double depth[kPieces + 1];
  double area[kPieces + 1];
  area[0] = 0;
  for (int k = 0; k <= kPieces; ++k) {
    depth[k] = std::max(0.0, RoughOverlapAt(axle, hump.begin + k * step));
    if (k > 0) area[k] = area[k - 1] + 0.5 * (depth[k - 1] + depth[k]);
  }
  const double share = area[kPieces] / kStripsPerHump;
  double from = hump.begin;
  int piece = 0;
  for (int k = 1; k <= kStripsPerHump; ++k) {
    while (piece + 1 < kPieces && area[piece + 1] < k * share) ++piece;
    const double rest = k * share - area[piece];
    const double rise = depth[piece + 1] - depth[piece];
    const double root = std::sqrt(std::max(0.0, depth[piece] * depth[piece] + 2 * rise * rest));
    const double part = 2 * rest / std::max(depth[piece] + root, 1e-30);
    const double to =
        k == kStripsPerHump ? hump.end : hump.begin + step * (piece + std::min(part, 1.0));
    const double width = to - from;
    const double at = 0.5 * (from + to);
    const Locus l = LocusAt(axle, at);
    const double stretch = std::sqrt(1 + l.wheel_slope * l.wheel_slope);
    const double cosine = 1 / stretch;
    const int n = strips->count++;
    strips->place[n] = at;
    strips->width[n] = width * stretch;
    strips->cosine[n] = cosine;
    strips->sine[n] = l.wheel_slope * cosine;
    strips->along[n] = 0.5 * cosine / l.radius;
    strips->overlap[n] = l.overlap * cosine;
    strips->x[n] = l.x;
    strips->y[n] = l.y;
    strips->z[n] = l.z;
    strips->slope[n] = l.slope;
    from = to;
  }
}

void ContactSearch::Moments::Add(const Moments& m, double share) {
  load += share * m.load;
  wheel += share * m.wheel;
  energy += share * m.energy;
  crowd += share * m.crowd;
  push_y += share * m.push_y;
  push_z += share * m.push_z;
  turn_x += share * m.turn_x;
  turn_y += share * m.turn_y;
  turn_z += share * m.turn_z;
}

ContactSearch::Moments ContactSearch::MomentsOf(const Axle& a, const StripLoads& strips,
                                                int i) const noexcept {
  const double f = strips.force[i];
  Moments m;
  m.load = f;
  m.wheel = f * strips.place[i];
  m.energy = strips.energy[i];
  const double load = f / strips.width[i];
  m.crowd = f * load * load * load * load;
  m.push_z = f * strips.cosine[i];
  m.push_y = -strips.slope[i] * m.push_z;
  m.turn_x = (strips.y[i] - a.y) * m.push_z - (strips.z[i] - a.z) * m.push_y;
  m.turn_y = -strips.x[i] * m.push_z;
  m.turn_z = strips.x[i] * m.push_y;
  return m;
}

void ContactSearch::Describe(const Axle& a, const Moments& m, Overlap* patch) const noexcept {
  Overlap& p = *patch;
  p.wheel_y = m.wheel / m.load;
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
  p.push = {0, m.push_y, m.push_z};
  p.turn = {m.turn_x, m.turn_y, m.turn_z};
  p.energy = m.energy;
  p.slope = -m.push_y / m.push_z;
  const double normal = std::sqrt(m.push_y * m.push_y + m.push_z * m.push_z);
  p.depth = 2.5 * m.energy / normal;
  const double half_width = kPeak * m.load * std::sqrt(std::sqrt(m.load / m.crowd));
  const double bend = 0.5 / (p.radius * std::sqrt(1 + p.slope * p.slope));
  p.across = hertz_.AcrossOfWidth(normal, bend, half_width);
}

void ContactSearch::Press(const Axle& axle, const Humps& humps, double all,
                          Overlaps* found) const noexcept {
  StripLoads strips;
  for (int k = 0; k < humps.count; ++k) AddStrips(axle, humps.hump[k], &strips);
  strips_.Press(&strips);
  Patches patches;
  FindPatches(axle, humps, strips, &patches);
  // Without room for every reading (three humps that all grow together) they are read as one.
  int readings = 0;
  for (int from = 0; from < patches.count; ++from) {
    int to = from;
    while (patches.merge_next[to] > 0) ++to;
    readings += to + 1 - from;
  }
  if (found->count + readings > kMaxOverlaps - (all < 1 && found->count == 0 ? kMaxHumps : 0)) {
    for (int k = 0; k + 1 < patches.count; ++k) patches.merge_next[k] = 1;
  }
  // Every way of reading neighbours as one patch, with its weight.
  for (int from = 0; from < patches.count; ++from) {
    Moments sum;
    double weight = from > 0 ? all * (1 - patches.merge_next[from - 1]) : all;
    bool at_end = false;
    for (int to = from; to < patches.count && weight > 0; ++to) {
      sum.Add(patches.patch[to], 1);
      at_end = at_end || patches.at_end[to];
      const double merge = patches.merge_next[to];
      const double share = weight * (1 - merge);
      weight *= merge;
      if (!(share > 0) || !(sum.load > 0) || found->count == kMaxOverlaps) continue;
      Overlap& patch = found->patch[static_cast<size_t>(found->count++)];
      Describe(axle, sum, &patch);
      patch.weight = share;
      patch.at_end = at_end || patch.wheel_y < wheel_.min_y() + kEnd ||
                     patch.wheel_y > wheel_.max_y() - kEnd || patch.y < rail_.min_y() + kEnd ||
                     patch.y > rail_.max_y() - kEnd;
    }
  }
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
  if (humps.count == 0) return;
  // Humps that have nearly grown together are also pressed as one: other strips, nearly the same
  // answer; so nothing jumps when the smaller one vanishes.
  int weakest = 0;
  for (int k = 1; k < humps.count; ++k) {
    if (humps.hump[k].next > humps.hump[weakest].next) weakest = k;
  }
  const double one = SmoothStep((humps.hump[weakest].next - kBlend) / (kSameHump - kBlend));
  if (one < 1) Press(axle, humps, 1 - one, found);
  if (!(one > 0)) return;
  Hump& joined = humps.hump[weakest];
  const Hump& last = humps.hump[weakest + 1];
  joined.end = last.end;
  joined.next = last.next;
  joined.at_end = joined.at_end || last.at_end;
  for (int k = weakest + 1; k + 1 < humps.count; ++k) humps.hump[k] = humps.hump[k + 1];
  --humps.count;
  Press(axle, humps, one, found);
}

}  // namespace phs::rail
