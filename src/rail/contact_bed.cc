#include "rail/contact_bed.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace phs::rail {
namespace {
double E(const char* n, double d) { const char* v = getenv(n); return v ? atof(v) : d; }

constexpr double kStep = 0.125e-3;     ///< of the table [m]
constexpr double kMostShift = 25e-3;   ///< of the wheel across the rail [m]
constexpr double kShiftStep = 0.1e-3;  ///< [m]
constexpr double kSearchStep = 0.5e-3; ///< on the wheel [m]
constexpr double kEnd = 1e-3;          ///< curvature is not asked for nearer to an end [m]
constexpr double kFlattest = 0.05;     ///< conformal regions carry a wide but finite patch [1/m]

/// Mean curvature over an arc of +-`half`: the turn of the surface over its length.
double MeanCurvature(const Profile& p, double y, double half) {
  const double slope = p.At(y).slope;
  const double dy = half / std::sqrt(1 + slope * slope);
  const double arc = std::hypot(2 * dy, p.At(y + dy).z - p.At(y - dy).z);
  return (std::atan(p.At(y + dy).slope) - std::atan(p.At(y - dy).slope)) / arc;
}

/// Where the upright wheel, moved outwards by `shift`, touches first; on the wheel.
double TouchOf(const Profile& wheel, const Profile& rail, double shift) {
  const double from = std::max(wheel.min_y(), rail.min_y() - shift) + kEnd;
  const double to = std::min(wheel.max_y(), rail.max_y() - shift) - kEnd;
  const auto depth = [&](double y) { return wheel.At(y).z - rail.At(y + shift).z; };
  double deepest = from;
  for (double y = from; y < to; y += kSearchStep) {
    if (depth(y) > depth(deepest)) deepest = y;
  }
  double low = std::max(from, deepest - kSearchStep);
  double high = std::min(to, deepest + kSearchStep);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (low + high);
    (wheel.At(middle).slope > rail.At(middle + shift).slope ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

ContactBed::ContactBed(const Profile& wheel, const Profile& rail, double radius,
                       const Hertz& hertz) {
  const int pieces = static_cast<int>(std::ceil((rail.max_y() - rail.min_y()) / kStep));
  begin_ = rail.min_y();
  per_step_ = pieces / (rail.max_y() - begin_);
  last_ = pieces - 1e-9;
  const double window = E("WINDOW", 0.5e-3);
  // From the middle outwards: what touches at the least shift counts.
  std::vector<double> raw(static_cast<size_t>(pieces) + 1, 0);
  struct Touch {
    double rail_y = 1e9, bed = 0;
  };
  Touch last[2];
  for (double size = 0; size < kMostShift; size += kShiftStep) {
    for (int way = 0; way < 2; ++way) {
      const double shift = way == 0 ? size : -size;
      const double y = TouchOf(wheel, rail, shift);
      const Profile::Sample s = wheel.At(y);
      const double across =
          0.5 * (MeanCurvature(rail, y + shift, window) - MeanCurvature(wheel, y, window));
      const double along = 0.5 / ((radius + s.z) * std::sqrt(1 + s.slope * s.slope));
      const Touch now{y + shift, hertz.BedModulus(along, std::max(across, E("FLAT", 0.05)))};
      const Touch& before = last[way];
      const bool near = std::abs(now.rail_y - before.rail_y) < E("GAP", 1e-3);
      const double from = near ? std::min(now.rail_y, before.rail_y) : now.rail_y;
      const double to = near ? std::max(now.rail_y, before.rail_y) : now.rail_y;
      for (auto k = std::lround((from - begin_) * per_step_); k <= std::lround((to - begin_) * per_step_); ++k) {
        if (k < 0 || k > pieces || raw[static_cast<size_t>(k)] > 0) continue;
        const double share = near ? std::clamp((begin_ + k / per_step_ - before.rail_y) / (now.rail_y - before.rail_y), 0.0, 1.0) : 1;
        raw[static_cast<size_t>(k)] = before.bed + share * (now.bed - before.bed);
      }
      last[way] = now;
    }
  }
  // Single steps between touches are filled, gaps are bridged by wide patches.
  const double gap = E("GAP", 1e-3);
  double flange = wheel.min_y() + kEnd;
  for (double y = flange; y < wheel.max_y() - kEnd; y += 0.1e-3) if (wheel.At(y).slope < wheel.At(flange).slope) flange = y;
  const auto bridged = [&](size_t j) {
    const double at = begin_ + static_cast<double>(j) / per_step_;
    double y = flange;
    while (y < wheel.max_y() - kEnd && wheel.At(y).slope < rail.At(at).slope) y += 0.05e-3;
    const Profile::Sample s = wheel.At(y);
    const double across = 0.5 * (MeanCurvature(rail, at, window) - MeanCurvature(wheel, y, window));
    const double along = 0.5 / ((radius + s.z) * std::sqrt(1 + s.slope * s.slope));
    if (getenv("DUMP")) std::printf("gap %.2f %.2f %.3f\n", 1e3*at, 1e3*y, across);
    return hertz.BedModulus(along, std::max(across, E("FLAT", 0.05)));
  };
  size_t before = raw.size();
  for (size_t i = 0; i < raw.size(); ++i) {
    if (!(raw[i] > 0)) continue;
    for (size_t j = before == raw.size() ? 0 : before + 1; j < i; ++j) {
      if (before == raw.size()) { raw[j] = raw[i]; continue; }
      const double share = static_cast<double>(j - before) / static_cast<double>(i - before);
      if (static_cast<double>(i - before) / per_step_ < gap) raw[j] = raw[before] + share * (raw[i] - raw[before]);
      else raw[j] = bridged(j);
    }
    before = i;
  }
  for (size_t j = before + 1; j < raw.size(); ++j) raw[j] = raw[before];
  // Evened out over the surface.
  std::vector<double> arc{0};
  for (int i = 0; i < pieces; ++i) {
    const double slope = rail.At(begin_ + (i + 0.5) / per_step_).slope;
    arc.push_back(arc.back() + std::sqrt(1 + slope * slope) / per_step_);
  }
  const double smooth = E("SMOOTH", 1.5e-3);
  for (size_t i = 0; i < raw.size(); ++i) {
    double sum = 0;
    double weights = 0;
    for (size_t j = 0; j < raw.size(); ++j) {
      const double weight = std::max(0.0, 1 - (getenv("ARC") ? std::abs(arc[j] - arc[i]) : std::abs(double(j) - double(i)) / per_step_) / smooth);
      sum += weight * raw[j];
      weights += weight;
    }
    bed_.push_back(sum / weights);
  }
}

}  // namespace phs::rail
