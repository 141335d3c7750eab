#include "rail/elastic_rail.h"

#include <Eigen/LU>
#include <cmath>

namespace phs::rail {
namespace {

constexpr int kIterations = 40;
constexpr int kRounds = 12;
constexpr double kTolerance = 1e-8;  ///< [m]
constexpr double kBack = 0.01;

double Dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

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
    normal[i] = NormalOf(p);
    stiffness[i] = p.weight * std::sqrt(Dot(p.push, p.push)) / (p.depth * std::sqrt(p.depth));
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
  Vec3 last_w{};
  Vec3 last_move{};
  for (int round = 0; round < kRounds; ++round) {
    search.Find(wheel, rail_y + w[1], rail_z + w[2], found);
    // A guess may lie beyond the end of contact.
    for (double back = kBack; found->count == 0 && back < 1; back *= 2) {
      for (size_t i = 1; i < 3; ++i) w[i] *= 1 - back;
      search.Find(wheel, rail_y + w[1], rail_z + w[2], found);
    }
    const Vec3 before = w;
    BendUnder(*found, s, before, &w);
    const Vec3 move = {0, w[1] - before[1], w[2] - before[2]};
    // The last bit is done with the shapes held.
    if (std::abs(move[1]) + std::abs(move[2]) < kTolerance) return move;
    // Shapes that alternate: the root of the moves between both places.
    const double back = Dot(last_move, move);
    if (back < 0) {
      const double share = Dot(last_move, last_move) / (Dot(last_move, last_move) - back);
      for (size_t i = 1; i < 3; ++i) w[i] = last_w[i] + share * (before[i] - last_w[i]);
    }
    last_w = before;
    last_move = move;
  }
  search.Find(wheel, rail_y + w[1], rail_z + w[2], found);
  return {};
}

}  // namespace phs::rail
