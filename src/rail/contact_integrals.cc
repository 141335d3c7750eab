// Integrals over a hump of overlap: where they are taken, and their sums (contact_search.h).
#include <algorithm>
#include <cmath>

#include "rail/contact_search.h"

namespace phs::rail {
namespace {

/// Two nodes at a time.
using Pair = double __attribute__((vector_size(16)));
struct PairMoments {
  Pair energy{}, load{}, bend{}, wheel{}, arm_x{}, arm_y{}, arm_z{};
  Pair push_y{}, push_z{}, turn_x{}, turn_y{}, turn_z{};
};

}  // namespace

void ContactSearch::Moments::Add(const Moments& m) {
  energy += m.energy;
  load += m.load;
  bend += m.bend;
  wheel += m.wheel;
  arm_x += m.arm_x;
  arm_y += m.arm_y;
  arm_z += m.arm_z;
  push_y += m.push_y;
  push_z += m.push_z;
  turn_x += m.turn_x;
  turn_y += m.turn_y;
  turn_z += m.turn_z;
}

double ContactSearch::StoredEnergy(double e) noexcept { return std::pow(e, 5.0 / 9); }

int ContactSearch::LevelOf(const Samples& s, const Hump& hump, double run) const {
  if (run < kNodesInHump * grid_[kLevels - 1].step) return kLevels;
  double widest = run / kNodesInHump;  // distance of nodes
  const int i = hump.sample;
  if (i > s.first && i < s.last) {  // a narrow top on a wide foot
    const double bend = 2 * Vertical(s, i) - Vertical(s, i - 1) - Vertical(s, i + 1);
    const double top =
        (WheelY(i + 1) - WheelY(i - 1)) * std::sqrt(2 * hump.depth / std::max(bend, 1e-12));
    widest = std::min(widest, top / kNodesInTop);
  }
  int level = 0;
  while (level + 1 < kLevels && grid_[level].step > widest) ++level;
  while (hump.end - hump.begin > 0.5 * kMaxNodes * grid_[level].step) --level;
  return level;
}

ContactSearch::Nodes ContactSearch::FindNodes(const Hump& hump, double* own) const noexcept {
  Nodes n;
  if (hump.level == kLevels) {
    n.step = (hump.end - hump.begin) / kNodesInHump;
    n.begin = hump.begin + 0.5 * n.step;
    n.low = -0.5;
    n.high = kNodesInHump - 0.5;
    n.first = 0;
    n.count = kNodesInHump;
    for (int k = 0; k < n.count; ++k) {
      const Profile::Sample s = wheel_.At(n.begin + n.step * k);
      own[k] = radius_ + s.z;
      own[kNodesInHump + k] = s.slope;
      own[2 * kNodesInHump + k] = s.second;
    }
    n.radius = own;
    n.slope = &own[kNodesInHump];
    n.second = &own[size_t{2} * kNodesInHump];
    return n;
  }
  const Grid& grid = grid_[hump.level];
  n.begin = begin_;
  n.step = grid.step;
  n.low = (hump.begin - begin_) / n.step;
  n.high = (hump.end - begin_) / n.step;
  n.first = std::max(0, static_cast<int>(std::ceil(n.low - 0.5)));
  const int end =
      std::min(static_cast<int>(grid.radius.size()), static_cast<int>(std::floor(n.high + 1.5)));
  n.count = std::clamp(end - n.first, 0, kMaxNodes);
  n.radius = grid.radius.data() + n.first;
  n.slope = grid.slope.data() + n.first;
  n.second = grid.second.data() + n.first;
  return n;
}

ContactSearch::Moments ContactSearch::Integrate(const Axle& a, const Hump& hump) const noexcept {
  double own[3 * kNodesInHump];
  const Nodes n = FindNodes(hump, own);
  const int count = n.count;
  // Humps that meet share the node between them (`weight`).
  if (count == 0) return {};
  // Pass by pass, so that the arithmetic between the look-ups is done two nodes at a time.
  double at[kMaxNodes], x[kMaxNodes], y[kMaxNodes], z[kMaxNodes], dy[kMaxNodes], slope[kMaxNodes];
  double rail_z[kMaxNodes], rail_slope[kMaxNodes], modulus[kMaxNodes];
  const double side = a.side * a.side;
  for (int k = 0; k < count; ++k) {
    const double t = n.slope[k];
    const double radius = n.radius[k];
    at[k] = n.begin + n.step * (n.first + k);
    const double along = half_tape_ + at[k];
    const double square = t * t * side;
    const double beta = 1 - square * (0.5 + square * (0.125 + square * 0.0625));
    const double uy = beta * a.beta_y - t * a.alpha_y;
    const double uz = beta * a.beta_z - t * a.alpha_z;
    x[k] = a.ex * (along + radius * t);
    y[k] = a.y + a.ey * along + radius * uy;
    z[k] = a.z + a.ez * along + radius * uz;
    slope[k] = -(uy - t * a.ey) / (uz - t * a.ez);
    dy[k] = a.ey + t * uy - radius * n.second[k] * (a.alpha_y + t * side * a.beta_y);
  }
  for (int k = 0; k < count; ++k) {
    const Profile::Sample r = rail_.At(y[k]);
    rail_z[k] = r.z;
    rail_slope[k] = r.slope;
    modulus[k] = modulus_.At(y[k]);
  }
  double h[kMaxNodes], weight[kMaxNodes], cosine[kMaxNodes];
  for (int k = 0; k < count; ++k) {
    h[k] = std::max(z[k] - rail_z[k], 0.0);
    weight[k] = n.step * dy[k] * modulus[k];
    cosine[k] = 1 / std::sqrt(1 + rail_slope[k] * rail_slope[k]);
  }
  weight[0] *= std::clamp(n.first - n.low + 0.5, 0.0, 1.0);
  weight[count - 1] *= std::clamp(n.high - n.first - count + 1.5, 0.0, 1.0);
  if (count % 2 == 1) {  // a node of nothing
    h[count] = weight[count] = 0;
    for (double* p : {at, x, y, z, slope, rail_slope, cosine}) p[count] = p[count - 1];
  }
  const auto pair = [](const double* p, int k) { return Pair{p[k], p[k + 1]}; };
  PairMoments m;
  for (int k = 0; k < count; k += 2) {
    const Pair overlap = pair(h, k), c = pair(cosine, k), locus = pair(slope, k);
    const Pair depth = overlap * c;
    const Pair load = pair(weight, k) * overlap * depth * depth;
    const Pair turned = (locus - pair(rail_slope, k)) * c * c;  // dg/ds
    const Pair arm_x = pair(x, k), arm_y = pair(y, k) - a.y, arm_z = pair(z, k) - a.z;
    const Pair push_z = load * c;
    const Pair push_y = -locus * push_z;
    m.energy += load * depth;
    m.load += load;
    m.bend += load * turned * turned;
    m.wheel += load * pair(at, k);
    m.arm_x += load * arm_x;
    m.arm_y += load * arm_y;
    m.arm_z += load * arm_z;
    m.push_y += push_y;
    m.push_z += push_z;
    m.turn_x += arm_y * push_z - arm_z * push_y;
    m.turn_y -= arm_x * push_z;
    m.turn_z += arm_x * push_y;
  }
  const auto sum = [](Pair p) { return p[0] + p[1]; };
  return {sum(m.energy), sum(m.load),   sum(m.bend),   sum(m.wheel),  sum(m.arm_x),  sum(m.arm_y),
          sum(m.arm_z),  sum(m.push_y), sum(m.push_z), sum(m.turn_x), sum(m.turn_y), sum(m.turn_z)};
}

}  // namespace phs::rail
