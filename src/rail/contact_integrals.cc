// Integrals over a hump of overlap: where they are taken, and their sums (contact_search.h).
#include <algorithm>
#include <cmath>

#include "base/wide.h"
#include "rail/contact_search.h"

namespace phs::rail {
namespace {

/// Four nodes at a time.
constexpr int kWide = 4;
using Wide = double __attribute__((vector_size(8 * kWide)));
/// The same at any address, in place of four numbers.
using WideInMemory [[gnu::aligned(8), gnu::may_alias]] = Wide;
struct WideMoments {
  Wide energy{}, load{}, bend{}, wheel{}, arm_x{}, arm_y{}, arm_z{};
  Wide push_y{}, push_z{}, turn_x{}, turn_y{}, turn_z{};
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
  const int levels = static_cast<int>(grid_.size());
  if (run < nodes_in_hump_ * grid_.back().step) return levels;
  double widest = run / nodes_in_hump_;  // distance of nodes
  const int i = hump.sample;
  if (i > s.first && i < s.last) {  // a narrow top on a wide foot
    const double bend = 2 * Vertical(s, i) - Vertical(s, i - 1) - Vertical(s, i + 1);
    const double top = (ArcAt(WheelY(i + 1)) - ArcAt(WheelY(i - 1))) *
                       std::sqrt(2 * hump.depth / std::max(bend, 1e-12));
    widest = std::min(widest, top / nodes_in_top_);
  }
  int level = 0;
  const auto step = [&](int i) { return grid_[static_cast<size_t>(i)].step; };
  while (level + 1 < levels && step(level) > widest) ++level;
  while (ArcAt(hump.end) - ArcAt(hump.begin) > 0.5 * kMaxNodes * step(level)) --level;
  return level;
}

ContactSearch::Nodes ContactSearch::FindNodes(const Hump& hump, double* own) const noexcept {
  Nodes n;
  if (hump.level == static_cast<int>(grid_.size())) {
    n.first = 0;
    n.count = nodes_in_hump_;
    n.low = -0.5;
    n.high = n.count - 0.5;
    double* at = own;
    double* radius = at + n.count;
    double* slope = radius + n.count;
    double* second = slope + n.count;
    double* across = second + n.count;
    const double step = (hump.end - hump.begin) / n.count;
    for (int k = 0; k < n.count; ++k) {
      at[k] = hump.begin + step * (k + 0.5);
      const Profile::Sample s = wheel_.At(at[k]);
      radius[k] = radius_ + s.z;
      slope[k] = s.slope;
      second[k] = s.second;
      across[k] = step;
    }
    n.at = at;
    n.radius = radius;
    n.slope = slope;
    n.second = second;
    n.across = across;
    return n;
  }
  const Grid& grid = grid_[static_cast<size_t>(hump.level)];
  n.low = ArcAt(hump.begin) / grid.step;
  n.high = ArcAt(hump.end) / grid.step;
  n.first = std::max(0, static_cast<int>(std::ceil(n.low - 0.5)));
  const int end =
      std::min(static_cast<int>(grid.at.size()), static_cast<int>(std::floor(n.high + 1.5)));
  n.count = std::clamp(end - n.first, 0, kMaxNodes);
  n.at = grid.at.data() + n.first;
  n.radius = grid.radius.data() + n.first;
  n.slope = grid.slope.data() + n.first;
  n.second = grid.second.data() + n.first;
  n.across = grid.across.data() + n.first;
  return n;
}

PHS_WIDE ContactSearch::Moments ContactSearch::Integrate(const Axle& a,
                                                         const Hump& hump) const noexcept {
  double own[5 * kNodesInHump * kMaxFineness];
  const Nodes n = FindNodes(hump, own);
  // Pass by pass, so that the arithmetic between the look-ups is done for several nodes at a time.
  // Rows of numbers, one for each node; a few spare ones fill the last block.
  constexpr int kRow = kMaxNodes + kWide;
  double at[kRow], x[kRow], y[kRow], z[kRow], h[kRow];
  double weight[kRow], slope[kRow], rail_slope[kRow], cosine[kRow];
  const double side = a.side * a.side;
  const auto root = [](double square) {
    return 1 - square * (0.5 + square * (0.125 + square * 0.0625));
  };
  for (int k = 0; k < n.count; ++k) {
    const double t = n.slope[k];
    const double beta = root(t * t * side);
    at[k] = n.at[k];
    y[k] = a.y + a.ey * (half_tape_ + at[k]) + n.radius[k] * (beta * a.beta_y - t * a.alpha_y);
    z[k] = a.z + a.ez * (half_tape_ + at[k]) + n.radius[k] * (beta * a.beta_z - t * a.alpha_z);
  }
  for (int k = 0; k < n.count; ++k) {
    const Profile::Sample r = rail_.At(y[k]);
    h[k] = z[k] - r.z;
    rail_slope[k] = r.slope;
  }
  // Nodes beyond the edges hold nothing.
  int begin = 0;
  int end = n.count;
  while (begin < end && !(h[begin] > 0)) ++begin;
  while (begin < end && !(h[end - 1] > 0)) --end;
  if (begin == end) return {};
  for (int k = begin; k < end; ++k) weight[k] = modulus_.At(y[k]);
  // Humps that meet share the node between them.
  if (begin == 0) weight[0] *= std::clamp(n.first - n.low + 0.5, 0.0, 1.0);
  if (end == n.count) weight[end - 1] *= std::clamp(n.high - n.first - end + 1.5, 0.0, 1.0);
  for (int k = begin; k < end; ++k) {
    const double t = n.slope[k];
    const double radius = n.radius[k];
    const double beta = root(t * t * side);
    const double uy = beta * a.beta_y - t * a.alpha_y;
    const double uz = beta * a.beta_z - t * a.alpha_z;
    x[k] = a.ex * (half_tape_ + at[k] + radius * t);
    slope[k] = -(uy - t * a.ey) / (uz - t * a.ez);
    weight[k] *=
        n.across[k] * (a.ey + t * uy - radius * n.second[k] * (a.alpha_y + t * side * a.beta_y));
    h[k] = std::max(h[k], 0.0);
    cosine[k] = 1 / std::sqrt(1 + rail_slope[k] * rail_slope[k]);
  }
  for (; (end - begin) % kWide != 0; ++end) {
    for (double* p : {at, x, y, z, slope, rail_slope, cosine}) p[end] = p[end - 1];
    h[end] = weight[end] = 0;
  }
  WideMoments m;
  for (int k = begin; k < end; k += kWide) {
    const auto four = [k](const double* p) -> const WideInMemory& {
      return *reinterpret_cast<const WideInMemory*>(p + k);
    };
    const Wide overlap = four(h), c = four(cosine), locus = four(slope);
    const Wide depth = overlap * c;
    const Wide load = four(weight) * overlap * depth * depth;
    const Wide turned = (locus - four(rail_slope)) * c * c;  // dg/ds
    const Wide arm_x = four(x), arm_y = four(y) - a.y, arm_z = four(z) - a.z;
    const Wide push_z = load * c;
    const Wide push_y = -locus * push_z;
    m.energy += load * depth;
    m.load += load;
    m.bend += load * turned * turned;
    m.wheel += load * four(at);
    m.arm_x += load * arm_x;
    m.arm_y += load * arm_y;
    m.arm_z += load * arm_z;
    m.push_y += push_y;
    m.push_z += push_z;
    m.turn_x += arm_y * push_z - arm_z * push_y;
    m.turn_y -= arm_x * push_z;
    m.turn_z += arm_x * push_y;
  }
  const auto sum = [](const Wide& p) { return (p[0] + p[1]) + (p[2] + p[3]); };
  return {sum(m.energy), sum(m.load),   sum(m.bend),   sum(m.wheel),  sum(m.arm_x),  sum(m.arm_y),
          sum(m.arm_z),  sum(m.push_y), sum(m.push_z), sum(m.turn_x), sum(m.turn_y), sum(m.turn_z)};
}

}  // namespace phs::rail
