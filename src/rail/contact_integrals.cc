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

PHS_WIDE ContactSearch::Moments ContactSearch::Integrate(const Axle& a,
                                                         const Hump& hump) const noexcept {
  // Humps that meet share the node between them: it reaches half a node to both sides.
  const double low = nodes_.PlaceOf(hump.begin);
  const double high = nodes_.PlaceOf(hump.end);
  const int first = std::max(0, static_cast<int>(std::ceil(hump.after ? low - 0.5 : low)));
  const int beyond = std::min(static_cast<int>(nodes_.at.size()),
                              static_cast<int>(std::floor(hump.joined ? high + 1.5 : high + 1)));
  const int count = std::clamp(beyond - first, 0, kMaxNodes);
  const double* at = nodes_.at.data() + first;
  const double* radius = nodes_.radius.data() + first;
  const double* wheel_slope = nodes_.slope.data() + first;
  const double* second = nodes_.second.data() + first;
  const double* across = nodes_.across.data() + first;
  // Pass by pass, so that the arithmetic between the look-ups is done for several nodes at a time.
  // Rows of numbers, one for each node; a few spare ones fill the last block.
  constexpr int kRow = kMaxNodes + kWide;
  double x[kRow], place[kRow], y[kRow], z[kRow], h[kRow];
  double weight[kRow], slope[kRow], rail_slope[kRow], cosine[kRow];
  const double side = a.side * a.side;
  const auto root = [](double square) {
    return 1 - square * (0.5 + square * (0.125 + square * 0.0625));
  };
  for (int k = 0; k < count; ++k) {
    const double t = wheel_slope[k];
    const double beta = root(t * t * side);
    place[k] = at[k];
    y[k] = a.y + a.ey * (half_tape_ + at[k]) + radius[k] * (beta * a.beta_y - t * a.alpha_y);
    z[k] = a.z + a.ez * (half_tape_ + at[k]) + radius[k] * (beta * a.beta_z - t * a.alpha_z);
  }
  for (int k = 0; k < count; ++k) {
    const Profile::Sample r = rail_.At(y[k]);
    h[k] = z[k] - r.z;
    rail_slope[k] = r.slope;
  }
  // Nodes beyond the edges hold nothing.
  int begin = 0;
  int end = count;
  while (begin < end && !(h[begin] > 0)) ++begin;
  while (begin < end && !(h[end - 1] > 0)) --end;
  if (begin == end) return {};
  for (int k = begin; k < end; ++k) weight[k] = modulus_.At(y[k]);
  if (begin == 0 && hump.after) weight[0] *= std::clamp(first - low + 0.5, 0.0, 1.0);
  if (end == count && hump.joined)
    weight[end - 1] *= std::clamp(high - first - end + 1.5, 0.0, 1.0);
  for (int k = begin; k < end; ++k) {
    const double t = wheel_slope[k];
    const double r = radius[k];
    const double beta = root(t * t * side);
    const double uy = beta * a.beta_y - t * a.alpha_y;
    const double uz = beta * a.beta_z - t * a.alpha_z;
    x[k] = a.ex * (half_tape_ + at[k] + r * t);
    slope[k] = -(uy - t * a.ey) / (uz - t * a.ez);
    weight[k] *= across[k] * (a.ey + t * uy - r * second[k] * (a.alpha_y + t * side * a.beta_y));
    h[k] = std::max(h[k], 0.0);
    cosine[k] = 1 / std::sqrt(1 + rail_slope[k] * rail_slope[k]);
  }
  for (; (end - begin) % kWide != 0; ++end) {
    for (double* p : {place, x, y, z, slope, rail_slope, cosine}) p[end] = p[end - 1];
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
    m.wheel += load * four(place);
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
