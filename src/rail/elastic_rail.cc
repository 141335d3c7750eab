#include "rail/elastic_rail.h"

#include <Eigen/LU>
#include <cmath>

namespace phs::rail {
namespace {

constexpr int kIterations = 40;
constexpr int kRounds = 12;
constexpr double kTolerance = 1e-8;  ///< [m]
constexpr double kBack = 0.01;
constexpr double kLongest = 5;  ///< step over rest

/// Displacement of an elastic, massless rail under the Hertz forces: k w = sum N n (2 x 2 Newton)
/// with shapes held as found at `from`.
void BendUnder(const Overlaps& found, const RailSupport& s, const Vec3& from, Vec3* bend) noexcept {
  Vec3& w = *bend;
  const double ky = s.lateral_stiffness_N_per_m, kz = s.vertical_stiffness_N_per_m;
  const Eigen::Vector2d give(ky > 0 ? 1 / ky : 0, kz > 0 ? 1 / kz : 0);
  double stiffness[kMaxOverlaps];  // N = stiffness depth^1.5
  Vec3 normal[kMaxOverlaps];
  for (int i = 0; i < found.count; ++i) {
    const Overlap& p = found.patch[static_cast<size_t>(i)];
    // Where humps merge a patch pushes a little beside its own normal.
    const double push = std::sqrt(p.push[1] * p.push[1] + p.push[2] * p.push[2]);
    normal[i] = {0, p.push[1] / push, p.push[2] / push};
    stiffness[i] = p.weight * push / (p.depth * std::sqrt(p.depth));
  }
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    // Residual in displacements, r = w - F(w)/k; jacobian = 1 + sum N' n n / k.
    Eigen::Vector2d r(w[1], w[2]);
    Eigen::Matrix2d j = Eigen::Matrix2d::Identity();
    const Vec3 moved = {0, w[1] - from[1], w[2] - from[2]};
    for (int i = 0; i < found.count; ++i) {
      const double depth = found.patch[static_cast<size_t>(i)].depth - Dot(normal[i], moved);
      if (!(depth > 0)) continue;
      const double root = stiffness[i] * std::sqrt(depth);
      const Eigen::Vector2d n(normal[i][1], normal[i][2]);
      r -= root * depth * give.cwiseProduct(n);
      j += 1.5 * root * give.cwiseProduct(n) * n.transpose();
    }
    const Eigen::Vector2d step = j.inverse() * r;
    w[1] -= step[0];
    w[2] -= step[1];
    if (step.lpNorm<1>() < 1e-14) break;
  }
}

}  // namespace

Vec3 NormalOf(const Overlap& patch) noexcept {
  const double cosine = 1 / std::sqrt(1 + patch.slope * patch.slope);
  return {0, -patch.slope * cosine, cosine};
}

Vec3 FindOnSupport(const ContactSearch& search, const WheelPlacement& wheel, double rail_y,
                   double rail_z, const RailSupport& s, Vec3* bend, Overlaps* found) noexcept {
  *bend = {};
  if (!(s.lateral_stiffness_N_per_m > 0) && !(s.vertical_stiffness_N_per_m > 0)) {
    search.Find(wheel, rail_y, rail_z, found);
    return {};
  }
  // The rail gives way far more than the contact: begin where its deepest points would push it.
  Vec3& w = *bend;
  search.FindPoints(wheel, rail_y, rail_z, ContactSearch::Depth::kNormal, found);
  if (found->count == 0) return {};
  BendUnder(*found, s, {}, &w);
  // r(w) = G(w) - w with G the place under held shapes; its slope is -1 but for what the shapes do
  // (Broyden 1965).
  Eigen::Matrix2d slope = -Eigen::Matrix2d::Identity();
  Eigen::Vector2d step, before;
  for (int round = 0; round < kRounds; ++round) {
    search.Find(wheel, rail_y + w[1], rail_z + w[2], found);
    // A guess may lie beyond the end of contact.
    for (double back = kBack; found->count == 0 && back < 1; back *= 2) {
      for (size_t i = 1; i < 3; ++i) w[i] *= 1 - back;
      search.Find(wheel, rail_y + w[1], rail_z + w[2], found);
    }
    const Vec3 from = w;
    BendUnder(*found, s, from, &w);
    const Eigen::Vector2d rest(w[1] - from[1], w[2] - from[2]);
    // The last bit is done with the shapes held.
    if (rest.lpNorm<1>() < kTolerance) return {0, rest[0], rest[1]};
    if (round > 0) {
      slope += (rest - before - slope * step) * step.transpose() / step.squaredNorm();
    }
    step = -slope.inverse() * rest;
    if (!(step.norm() < kLongest * rest.norm())) step = rest;
    before = rest;
    w = {0, from[1] + step[0], from[2] + step[1]};
  }
  search.Find(wheel, rail_y + w[1], rail_z + w[2], found);
  return {};
}

}  // namespace phs::rail
