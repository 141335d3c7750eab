// Humps of overlap that are pressed into one half-space: each lowers the surface under the others.
#include <algorithm>
#include <cmath>

#include "rail/contact_search.h"

namespace phs::rail {
namespace {

constexpr int kRounds = 30;
constexpr double kTolerance = 1e-13;  ///< of a hump's depth

}  // namespace

double ContactSearch::Mutual(const Axle& axle, const Moments& a, const Moments& b) const noexcept {
  const Locus p = LocusAt(axle, a.wheel / a.load);
  const Locus q = LocusAt(axle, b.wheel / b.load);
  const double cosine = (1 + p.slope * q.slope) /
                        std::sqrt((1 + p.slope * p.slope) * (1 + q.slope * q.slope));
  const double far = std::hypot(p.y - q.y, p.z - q.z) / compliance_;
  // Mean give of each under its own load: twice the energy over the load squared.
  const double own = 4 * a.energy * b.energy / (a.push() * a.push() * b.push() * b.push());
  return std::max(cosine, 0.0) / std::sqrt(far * far + 1 / own);
}

void ContactSearch::Couple(const Axle& axle, const Humps& humps, Moments* moments) const noexcept {
  const int n = humps.count;
  double give[kMaxHumps][kMaxHumps];
  double depth[kMaxHumps], load[kMaxHumps], left[kMaxHumps];
  for (int k = 0; k < n; ++k) {
    const Moments& m = moments[k];
    if (!(m.i > 0)) return;  // just touching: nothing to share
    depth[k] = left[k] = 1.25 * m.square / m.i;
    load[k] = m.push();
    double apart = 1;
    for (int j = k - 1; j >= 0; --j) {
      apart *= humps.hump[j].merge_next;
      give[k][j] = give[j][k] = apart < 1 ? (1 - apart) * Mutual(axle, moments[j], m) : 0;
    }
  }
  const auto carried = [&](int k) {
    const double share = left[k] / depth[k];
    return load[k] * share * std::sqrt(share);
  };
  for (int round = 0; round < kRounds; ++round) {
    double moved = 0;
    for (int k = 0; k < n; ++k) {
      double rest = depth[k];
      for (int j = 0; j < n; ++j) {
        if (j != k) rest -= give[k][j] * carried(j);
      }
      rest = std::max(rest, 0.0);
      moved = std::max(moved, std::abs(rest - left[k]) / depth[k]);
      left[k] = rest;
    }
    if (moved < kTolerance) break;
  }
  double energy[kMaxHumps];
  for (int k = 0; k < n; ++k) {
    energy[k] = 0.4 * carried(k) * left[k];
    for (int j = 0; j < n; ++j) {
      if (j != k) energy[k] += 0.5 * give[k][j] * carried(k) * carried(j);
    }
  }
  for (int k = 0; k < n; ++k) {
    const double share = left[k] / depth[k];
    moments[k].Scale(share, energy[k] / (0.4 * load[k] * depth[k]));
  }
}

}  // namespace phs::rail
