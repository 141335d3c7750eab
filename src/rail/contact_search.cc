#include "rail/contact_search.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"

namespace phs::rail {
namespace {

constexpr double kWheelStep = 0.9e-3;   ///< of the coarse samples [m]
constexpr double kRailStep = 0.125e-3;  ///< of the rail's chords [m]
constexpr double kBeyond = 4e-3;        ///< samples beyond the ends of the rail [m]
constexpr double kDoubt = 2e-6;  ///< chords of the rail's table are this near to it, normal [m]
/// Flattest relative curvature across: conformal regions carry a wide but finite patch.
constexpr double kFlattest = 0.05;

/// beta = sqrt(1 - x^2); |x| <= 0.3 for slopes up to 6 and yaw up to 50 mrad, error below 1e-9.
double RootOfRest(double square) {
  if (square > 0.02) return std::sqrt(std::max(0.0, 1 - square));
  return 1 - square * (0.5 + square * (0.125 + square * (0.0625 + square * (5.0 / 128))));
}

}  // namespace

ContactSearch::ContactSearch(Profile wheel, Profile rail, double half_tape, double radius,
                             const Hertz& hertz, int fineness)
    : wheel_(std::move(wheel)),
      rail_(std::move(rail)),
      half_tape_(half_tape),
      radius_(radius),
      modulus_(wheel_, rail_, radius, hertz),
      nodes_(wheel_, rail_, radius, fineness) {
  begin_ = wheel_.min_y();
  PlaceSamples(kWheelStep / fineness);
  MeasureMargins();
  const double rail_width = rail_.max_y() - rail_.min_y();
  // With finer samples the kinks between chords would look like ridges between humps.
  const int pieces = static_cast<int>(std::ceil(rail_width / kRailStep * fineness));
  rail_begin_ = rail_.min_y();
  rail_per_step_ = pieces / rail_width;
  for (int i = 0; i < pieces; ++i) {
    const double z = rail_.At(rail_begin_ + i / rail_per_step_).z;
    rail_pieces_.push_back({z, rail_.At(rail_begin_ + (i + 1) / rail_per_step_).z - z});
  }
}

void ContactSearch::PlaceSamples(double step) {
  const double width = wheel_.max_y() - begin_;
  const int pieces = std::clamp(static_cast<int>(std::ceil(width / step)), 1, kMaxSamples - 1);
  half_step_ = 0.5 * width / pieces;
  samples_ = pieces + 1;
  for (int i = 0; i < samples_; ++i) {
    coarse_.Add(wheel_, begin_, 2 * i * half_step_, radius_);
    if (i < pieces) middle_.Add(wheel_, begin_, (2 * i + 1) * half_step_, radius_);
  }
}

void ContactSearch::Row::Add(const Profile& wheel, double begin, double at, double radius) {
  const Profile::Sample s = wheel.At(begin + at);
  const double r = radius + s.z;
  along.push_back(at);
  down.push_back(r);
  slope.push_back(r * s.slope);
  square.push_back(0.5 * r * s.slope * s.slope);
  stretch.push_back(std::sqrt(1 + s.slope * s.slope));
  cosine.push_back(1 / stretch.back());
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
  l.x = a.ex * (along + radius * t);
  l.y = a.y + a.ey * along + radius * uy;
  l.z = a.z + a.ez * along + radius * uz;
  l.slope = -(uy - t * a.ey) / (uz - t * a.ez);
  l.stretch =
      a.ey + t * uy - radius * s.second * (a.alpha_y + t * a.side * a.side / beta * a.beta_y);
  const Profile::Sample r = rail_.At(l.y);
  l.rail_slope = r.slope;
  l.overlap = l.z - r.z;
  l.wheel_bend = s.second;
  l.rail_bend = r.second * l.stretch;
  return l;
}

void ContactSearch::Sample(const Axle& a, Samples* samples) const noexcept {
  // Only the part of the wheel that lies over the rail, and kBeyond more.
  const double centre = a.y + half_tape_ * a.ey + radius_ * a.beta_y;
  const double from = rail_.min_y() - centre - begin_ - kBeyond;
  const double to = rail_.max_y() - centre - begin_ + kBeyond;
  samples->first = 0;
  samples->last = -1;
  if (!(from < coarse_.along.back() && to > 0)) return;  // not a number, or far away
  const double per_sample = 0.5 / half_step_;
  samples->first = std::max(static_cast<int>(std::ceil(from * per_sample)) - 1, 0);
  samples->last = std::min(static_cast<int>(std::ceil(to * per_sample)), samples_ - 1);
  SampleRow(a, coarse_, samples->first, samples->last + 1, samples->coarse);
}

void ContactSearch::SampleMiddles(const Axle& a, int from, int end,
                                  Samples* samples) const noexcept {
  SampleRow(a, middle_, std::max(from, samples->first), std::min(end, samples->last),
            samples->middle);
}

PHS_WIDE void ContactSearch::SampleRow(const Axle& a, const Row& row, int first, int end,
                                       double* depth) const noexcept {
  // y and z of the locus with beta = 1 - t^2 side^2/2; place in the rail's table.
  const double side = a.side * a.side;
  const double rail_end = static_cast<double>(rail_pieces_.size() - 1);
  const double y0 = (a.y + a.ey * (half_tape_ + begin_) - rail_begin_) * rail_per_step_;
  const double y1 = a.ey * rail_per_step_;
  const double y2 = a.beta_y * rail_per_step_;
  const double y3 = a.alpha_y * rail_per_step_;
  const double z0 = a.z + a.ez * (half_tape_ + begin_);
  const double *along = row.along.data(), *radius = row.down.data(), *slope = row.slope.data();
  const double *square = row.square.data(), *cosine = row.cosine.data();
  // Loop by loop, so that all but the look-up itself is done for several samples at a time.
  double beyond[kMaxSamples], z[kMaxSamples];
  int piece[kMaxSamples];
  for (int i = first; i < end; ++i) {
    const double down = radius[i] - side * square[i];
    const double place = y0 + y1 * along[i] + y2 * down - y3 * slope[i];
    z[i] = z0 + a.ez * along[i] + a.beta_z * down - a.alpha_z * slope[i];
    // Beyond the ends the rail goes on straight, as its profile does.
    double inside = place > 0 ? place : 0;
    inside = inside < rail_end ? inside : rail_end;
    piece[i] = static_cast<int>(inside);
    beyond[i] = place - piece[i];
  }
  for (int i = first; i < end; ++i) {
    const RailPiece& p = rail_pieces_[static_cast<size_t>(piece[i])];
    z[i] -= p.z + beyond[i] * p.rise;
  }
  int doubtful = 0;
  for (int i = first; i < end; ++i) {
    depth[i] = z[i] * cosine[i];
    doubtful += std::abs(depth[i]) < kDoubt ? 1 : 0;
  }
  if (doubtful == 0) return;
  // Whether a sample overlaps at all is said by the rail itself.
  for (int i = first; i < end; ++i) {
    if (std::abs(depth[i]) < kDoubt) depth[i] = LocusAt(a, begin_ + along[i]).overlap * cosine[i];
  }
}

void ContactSearch::Describe(const Axle& a, const Moments& m, double stored,
                             Overlap* patch) const noexcept {
  Overlap& p = *patch;
  p.wheel_y = m.wheel / m.load;
  p.arm = {m.arm_x / m.load, m.arm_y / m.load, m.arm_z / m.load};
  // From the axle: what is square to it.
  const double along = a.ex * p.arm[0] + a.ey * p.arm[1] + a.ez * p.arm[2];
  p.radius =
      std::sqrt(p.arm[0] * p.arm[0] + p.arm[1] * p.arm[1] + p.arm[2] * p.arm[2] - along * along);
  p.y = a.y + p.arm[1];
  p.z = a.z + p.arm[2];
  p.energy = stored;
  const double scale = 20.0 / 9 * p.energy / m.energy;
  p.push = {0, scale * m.push_y, scale * m.push_z};
  p.turn = {scale * m.turn_x, scale * m.turn_y, scale * m.turn_z};
  p.slope = -m.push_y / m.push_z;
  p.depth = 1.125 * m.energy / m.load;
  p.across = std::max(2 * m.bend / m.energy, kFlattest);
}

void ContactSearch::Find(const WheelPlacement& wheel, double rail_y, double rail_z,
                         Overlaps* found) const noexcept {
  const Axle axle = PlaceAxle(wheel, rail_y, rail_z);
  Samples samples;
  Sample(axle, &samples);
  Humps humps;
  FindHumps(axle, &samples, &humps);
  found->count = 0;
  found->axle = {axle.ex, axle.ey, axle.ez};
  Moments moments[kMaxHumps];
  for (int k = 0; k < humps.count; ++k) moments[k] = Integrate(axle, humps.hump[k]);
  for (int first = 0, last = 0; first < humps.count; first = ++last) {
    while (humps.hump[last].next.m > 0) ++last;  // humps that merge: `first` … `last`
    const int begin = found->count;
    const Readings readings = ReadEnergies(moments, first, last);
    for (int k = first; k <= last; ++k) AddReadings(axle, humps, k, moments, readings, found);
    if (last > first) AddMerging(axle, humps, first, last, readings, begin, found);
  }
}

}  // namespace phs::rail
