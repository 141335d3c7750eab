// Humps that grow together: how far, the ways of reading them, and the wrench of their merging
// (contact_search.h).
#include <algorithm>
#include <cmath>

#include "rail/contact_search.h"

namespace phs::rail {
namespace {

/// From 3^(2/3) on m is 0.
constexpr double kApart = 2.081;
constexpr double kNearEnd = 0.5e-3;  ///< contact this near to an end is at the end [m]

double SizeOf(const Overlap& p) { return std::sqrt(p.push[1] * p.push[1] + p.push[2] * p.push[2]); }

}  // namespace

void ContactSearch::Link(const Axle& axle, Samples* samples, Hump* hump,
                         Hump* next) const noexcept {
  const Samples& s = *samples;
  Merge& merge = hump->next;
  const int from = hump->sample < 0 ? hump->beside + 2 : hump->sample;
  const int to = next->sample < 0 ? next->beside : next->sample;
  // Both neighbours of each are looked at.
  if (!hump->joined) SampleMiddles(axle, from / 2 - 1, to / 2 + 1, samples);
  int lowest = from;
  double between = Vertical(s, from);
  for (int i = from + 1; i <= to; ++i) {
    const double there = Vertical(s, i);
    if (!(there < between)) continue;
    between = there;
    lowest = i;
  }
  // The tops may rise above their samples; what is surely apart is left at once.
  const auto most = [&](const Hump& h) {
    if (h.sample < 0) return h.depth;
    const auto i = static_cast<size_t>(h.sample / 2);
    const double margin =
        h.sample % 2 == 0 && i > 0 ? std::max(margin_[i - 1], margin_[i]) : margin_[i];
    return h.depth + coarse_.stretch[i] * margin;
  };
  if ((1 - between / most(*hump)) * (1 - between / most(*next)) > kApart) return;
  const int at_sample[] = {lowest, hump->sample, next->sample};
  double ridge = 0;
  double h[3];
  for (int i = 0; i < 3; ++i) {
    if (at_sample[i] < 0) {
      merge.locus[i] = LocusAt(axle, i == 1 ? hump->top : next->top);
    } else {
      double at = 0;
      merge.locus[i] = StationaryNear(axle, s, at_sample[i], i == 0 ? -1 : 1, &at);
      if (i == 0) ridge = at;
    }
    h[i] = merge.locus[i].overlap;
  }
  const double first = std::max(1 - h[0] / h[1], 0.0);
  const double second = std::max(1 - h[0] / h[2], 0.0);
  const double apart = first * second;
  const double root = std::sqrt(apart);
  const double close = std::max(1 - apart * root / 3, 0.0);
  merge.m = close * close * close;
  const double slope = 1.5 * root * close * close;  // -dm/d apart
  merge.slope[0] = slope * (second / h[1] + first / h[2]);
  merge.slope[1] = -slope * second * h[0] / (h[1] * h[1]);
  merge.slope[2] = -slope * first * h[0] / (h[2] * h[2]);
  if (!hump->joined) return;
  hump->end = next->begin = ridge;
}

ContactSearch::Readings ContactSearch::ReadEnergies(const Moments* moments, int first,
                                                    int last) noexcept {
  Readings u;
  for (int from = first; from <= last; ++from) {
    double energy = 0;
    for (int to = from; to <= last; ++to) {
      energy += moments[to].energy;
      u.stored[from][to] = StoredEnergy(energy);
    }
  }
  return u;
}

void ContactSearch::AddReadings(const Axle& axle, const Humps& humps, int from,
                                const Moments* moments, const Readings& readings,
                                Overlaps* found) const noexcept {
  Moments sum;
  double weight = from > 0 ? 1 - humps.hump[from - 1].next.m : 1;
  bool at_end = false;
  for (int to = from; to < humps.count && weight > 0; ++to) {
    sum.Add(moments[to]);
    at_end = at_end || humps.hump[to].at_end;
    const double merge = humps.hump[to].next.m;
    const double share = weight * (1 - merge);
    weight *= merge;
    if (!(share > 0) || !(sum.energy > 0)) continue;
    Overlap& patch = found->patch[static_cast<size_t>(found->count++)];
    Describe(axle, sum, readings.stored[from][to], &patch);
    patch.weight = share;
    patch.at_end = at_end || patch.wheel_y < wheel_.min_y() + kNearEnd ||
                   patch.wheel_y > wheel_.max_y() - kNearEnd ||
                   patch.y < rail_.min_y() + kNearEnd || patch.y > rail_.max_y() - kNearEnd;
  }
}

double ContactSearch::EnergyOfMerging(const Humps& humps, int first, int last, int ridge,
                                      const Readings& readings) noexcept {
  const auto merge = [&](int k) { return humps.hump[k].next.m; };
  double change = 0;
  for (int from = first; from <= ridge + 1; ++from) {
    double weight = from > first && from - 1 != ridge ? 1 - merge(from - 1) : 1;
    for (int to = from; to <= last; ++to) {
      const double ends = to < last && to != ridge ? 1 - merge(to) : 1;
      if (to >= ridge) {
        const bool across = from <= ridge && to > ridge;
        change += (across ? 1 : -1) * weight * ends * readings.stored[from][to];
      }
      if (to != ridge) weight *= merge(to);
    }
  }
  return change;
}

void ContactSearch::AddMerging(const Axle& a, const Humps& humps, int first, int last,
                               const Readings& readings, int begin,
                               Overlaps* found) const noexcept {
  Vec3 push{}, turn{};
  for (int k = first; k < last; ++k) {
    const Merge& merge = humps.hump[k].next;
    const double change = EnergyOfMerging(humps, first, last, k, readings);
    for (int i = 0; i < 3; ++i) {
      const Locus& l = merge.locus[i];
      const double z = change * merge.slope[i];
      const double y = -z * l.slope;
      push[1] += y;
      push[2] += z;
      turn[0] += (l.y - a.y) * z - (l.z - a.z) * y;
      turn[1] -= l.x * z;
      turn[2] += l.x * y;
    }
  }
  double all = 0;
  for (int i = begin; i < found->count; ++i) {
    const Overlap& p = found->patch[static_cast<size_t>(i)];
    all += p.weight * SizeOf(p);
  }
  for (int i = begin; i < found->count; ++i) {
    Overlap& p = found->patch[static_cast<size_t>(i)];
    const double share = SizeOf(p) / all;
    for (size_t j = 0; j < 3; ++j) {
      p.push[j] += share * push[j];
      p.turn[j] += share * turn[j];
    }
  }
}

}  // namespace phs::rail
