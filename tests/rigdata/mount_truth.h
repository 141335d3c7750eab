// What lies between the actuator and the piston of the true rig, in the line of force.
// δ = x_actuator − x_piston, m; F = force through the mount, tension > 0, N.
//
//   clearance:  u = δ beyond ± gap/2, else 0 (no force inside)
//   spring:     F = k u · shape(u)           elastic part, four shapes
//   branches:   F += Σ k_i (u − y_i),  ẏ_i = (u − y_i)/τ_i   (Maxwell branches, implicit)
#pragma once

#include <array>
#include <vector>

namespace rigdata {

enum class SpringForm { kLinear, kHardening, kUnequal, kContact };

struct MaxwellBranch {
  double share = 0;  // stiffness / spring stiffness
  double tau = 1;    // s
};

struct MountParams {
  bool rigid = true;
  double gap = 0;          // m
  double stiffness = 1e9;  // N/m
  SpringForm form = SpringForm::kLinear;
  double shape = 0;  // kHardening: 1/m² · u²; kUnequal: pull stiffness = k (1 + shape)
  std::vector<MaxwellBranch> branches;
};

inline constexpr int kMaxBranches = 6;

struct MountState {
  std::array<double, kMaxBranches> creep{};  // m, y_i
};

class MountTruth {
 public:
  explicit MountTruth(const MountParams& params) : params_(params) {}
  bool rigid() const { return params_.rigid; }
  // Force after a step of h that ends at δ. Monotone in δ.
  double Force(const MountState& before, double delta, double h, MountState* after) const;

 private:
  MountParams params_;
};

}  // namespace rigdata
