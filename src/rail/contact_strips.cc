#include "rail/contact_strips.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace phs::rail {
namespace {

constexpr double kStep = 0.25e-3;    ///< of the table [m]
constexpr double kHalfPatch = 3e-3;  ///< over which curvature is felt, arc length [m]
constexpr double kFlattest = 0.05;   ///< conformal regions [1/m]
constexpr double kOwn = 0.21;        ///< l of wide patches
constexpr double kNarrow = 500;
constexpr double kShare = 0.0843;  ///< s of narrow patches
constexpr double kPartnerStep = 0.1e-3;
constexpr double kThinnest = 1e-12;  ///< overlap [m]
constexpr int kRounds = 12;

/// Where the wheel falls most steeply inwards.
double FlangeOf(const Profile& wheel) {
  double flange = wheel.min_y() + kHalfPatch;
  for (double y = flange; y < wheel.max_y() - kHalfPatch; y += kPartnerStep) {
    if (wheel.At(y).slope < wheel.At(flange).slope) flange = y;
  }
  return flange;
}

/// Mean curvature over the width, from the second difference normal to the surface.
double MeanCurvature(const Profile& p, double y) {
  const double slope = p.At(y).slope;
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  const double dy = kHalfPatch * cosine;
  return (p.At(y + dy).z + p.At(y - dy).z - 2 * p.At(y).z) * cosine / (kHalfPatch * kHalfPatch);
}

/// The rail point with the wheel's slope, from the rail's inner end outwards.
double PartnerOf(const Profile& rail, double slope) {
  double y = rail.min_y() + kHalfPatch;
  while (y < rail.max_y() - kHalfPatch && rail.At(y).slope < slope) y += kPartnerStep;
  return y;
}

}  // namespace

ContactStrips::ContactStrips(const Profile& wheel, const Profile& rail, double radius,
                             double modulus)
    : modulus_(std::numbers::pi * modulus) {
  const int pieces = static_cast<int>(std::ceil((wheel.max_y() - wheel.min_y()) / kStep));
  begin_ = wheel.min_y();
  per_step_ = pieces / (wheel.max_y() - begin_);
  last_ = pieces - 1e-9;
  const double flange = FlangeOf(wheel);
  double arc = 0;
  for (int i = 0; i <= pieces; ++i) {
    const double y = begin_ + i / per_step_;
    const double slope = wheel.At(y).slope;
    const double stretch = std::sqrt(1 + slope * slope);
    // Inside of the flange's steepest place the wheel meets what the steepest place meets.
    const double partner = PartnerOf(rail, y < flange ? wheel.At(flange).slope : slope);
    const double across =
        std::max(kFlattest, 0.5 * (MeanCurvature(rail, partner) - MeanCurvature(wheel, y)));
    const double ratio = across * 2 * (radius + wheel.At(y).z) * stretch;
    table_.push_back({arc, kOwn / (1 + ratio / kNarrow), kShare * (ratio + 0.15) / (ratio + 0.23)});
    arc += stretch / per_step_;
  }
}

void ContactStrips::Give(const StripLoads& s, Compliance* c) const noexcept {
  double arc[kMaxStrips];
  for (int i = 0; i < s.count; ++i) {
    const double place = std::clamp((s.place[i] - begin_) * per_step_, 0.0, last_);
    const auto k = static_cast<size_t>(place);
    const double t = place - static_cast<double>(k);
    const Place& p = table_[k];
    const Place& q = table_[k + 1];
    arc[i] = p.arc + t * (q.arc - p.arc);
    const double overlap = std::max(s.overlap[i], kThinnest);
    c->level[i] = (p.share + t * (q.share - p.share)) * std::sqrt(overlap / s.along[i]);
    const double z = s.width[i] / (4 * c->level[i]);
    const double root = 1 / std::sqrt(1 + z * z / 3);
    c->give[i][i] = (p.own + t * (q.own - p.own) + 2 * z * root) / s.width[i];
    c->fall[i][i] = 2 * root * root * root * z / (c->level[i] * s.width[i]);
  }
  for (int i = 1; i < s.count; ++i) {
    for (int j = 0; j < i; ++j) {
      const double r = arc[i] - arc[j];
      const double p = c->level[i] + c->level[j];
      const double turned = s.cosine[i] * s.cosine[j] + s.sine[i] * s.sine[j];
      const double inverse = 1 / (r * r + r * p + p * p);
      c->give[i][j] = turned * (r + p) * inverse;
      c->fall[i][j] = turned * p * (2 * r + p) * inverse * inverse;
    }
  }
}

namespace {

/// Loads of the strips `order` whose overlaps are all taken up: LDL^T, column by column.
void Solve(const double (*give)[kMaxStrips], const double* overlap, const int* order, int m,
           double* load) {
  double rest[kMaxStrips][kMaxStrips];  // [column][row]
  double inverse[kMaxStrips];
  for (int a = 0; a < m; ++a) {
    for (int b = a; b < m; ++b) rest[a][b] = give[order[b]][order[a]];
    load[a] = overlap[order[a]];
  }
  for (int a = 0; a < m; ++a) {
    inverse[a] = 1 / rest[a][a];
    for (int b = a + 1; b < m; ++b) {
      const double factor = rest[a][b] * inverse[a];
      for (int c = b; c < m; ++c) rest[b][c] -= factor * rest[a][c];
      load[b] -= factor * load[a];
    }
  }
  for (int a = m - 1; a >= 0; --a) {
    double value = load[a];
    for (int b = a + 1; b < m; ++b) value -= rest[a][b] * load[b];
    load[a] = value * inverse[a];
  }
}

}  // namespace

void ContactStrips::Press(StripLoads* loads) const noexcept {
  StripLoads& s = *loads;
  Compliance c;
  Give(s, &c);
  // Strips leave when they would pull and return when they would be overlapped.
  bool in[kMaxStrips];
  double x[kMaxStrips];  // w x
  // The outermost strips of a hump are shallow and mostly bear nothing.
  for (int i = 0; i < s.count; ++i) {
    const int k = i % kStripsPerHump;
    in[i] = s.overlap[i] > 0 && k > 0 && k + 1 < kStripsPerHump;
  }
  const auto at = [&](int i, int j) { return i > j ? c.give[i][j] : c.give[j][i]; };
  for (int round = 0; round < kRounds; ++round) {
    int order[kMaxStrips];
    double load[kMaxStrips];
    int m = 0;
    for (int i = 0; i < s.count; ++i) {
      x[i] = 0;
      if (in[i]) order[m++] = i;
    }
    Solve(c.give, s.overlap, order, m, load);
    bool changed = false;
    for (int a = 0; a < m; ++a) {
      x[order[a]] = std::max(load[a], 0.0);
      if (load[a] < 0) {
        in[order[a]] = false;
        changed = true;
      }
    }
    if (changed) continue;
    for (int i = 0; i < s.count; ++i) {
      if (in[i]) continue;
      double rest = s.overlap[i];
      for (int a = 0; a < m; ++a) rest -= at(i, order[a]) * load[a];
      if (rest > 1e-15) in[i] = changed = true;
    }
    if (!changed) break;
  }
  for (int i = 0; i < s.count; ++i) {
    s.energy[i] = 0.5 * modulus_ * x[i] * s.overlap[i];
    double fall = 0.5 * c.fall[i][i] * x[i];
    for (int j = 0; j < i; ++j) fall += c.fall[i][j] * x[j];
    for (int j = i + 1; j < s.count; ++j) fall += c.fall[j][i] * x[j];
    s.force[i] =
        modulus_ * x[i] * (1 + fall * c.level[i] / (2 * std::max(s.overlap[i], kThinnest)));
  }
}

}  // namespace phs::rail
