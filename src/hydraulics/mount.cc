// What lies between mounting and piston: free play in series with a spring and a Maxwell branch.
//
//   x o--[ gap ]--+--[ k ]-------------+--o y piston        u = x - y (state), e = play-free part
//   of u
//                 +--[ k2 ]--q--[ c ]--+  (one or two)
//   F = k e (1 + b e²) [times r for e > 0] + sum k2 (e - q),  dq/dt = k2 (e - q)/c,
//   e = u beyond the play: u - s gap above s gap, u + (1-s) gap below -(1-s) gap, s = 1/2 in the
//   middle
// The piston has no mass worth a state: F = pressure force + end stop + friction(dy/dt), which is
// solved for the piston's move over the step by backward Euler. The sum rises with the move, so a
// bracketed Newton finds it; cylinders that share lines are swept until none moves any more
// (descent in one convex potential, one block at a time).
#include <algorithm>
#include <cmath>

#include "hydraulics/phs_impl.h"

namespace phs::hydraulics {
namespace {

constexpr double kSmallestStep = 1e-7;  // [s] stands for "now" in instantaneous rates

// Force balance of one piston that moves by `move` during h: value rises with `move`.
class PistonBalance {
 public:
  PistonBalance(const CompiledPhs& sys, double h, double x_end, int cylinder, const double* state,
                Instant* at)
      : sys_(sys),
        c_(sys.cylinders[cylinder]),
        h_(h),
        x_end_(x_end),
        state_(state),
        at_(at),
        cylinder_(cylinder),
        start_(at->piston[cylinder]) {}

  double Calc(double move, double* slope) {
    Place(start_ + move);
    const double k_bore =
        c_.bore != kOpen ? c_.bore_area * c_.bore_area / at_->node[c_.bore].slope : 0;
    const double k_rod = c_.rod != kOpen ? c_.rod_area * c_.rod_area / at_->node[c_.rod].slope : 0;
    const double speed = move / h_;
    const EndStopForce stop = CalcEndStop(c_.stop, start_ + move, speed);
    double friction_slope, mount_slope;
    const double friction = FrictionAfter(move, &friction_slope);
    MountTerms stepped = c_.mount;
    for (int k = 0; k < MountTerms::kBranches; ++k) {
      if (c_.maxwell[k] < 0) continue;
      // Backward Euler of q folded into the branch stiffness.
      stepped.maxwell_stiffness_N_per_m[k] /=
          1 + h_ * c_.mount.maxwell_stiffness_N_per_m[k] / c_.mount.maxwell_damping_Ns_per_m[k];
    }
    const double mount =
        CalcMountForce(stepped, x_end_ - start_ - move, c_.Creep(state_), &mount_slope);
    *slope = k_bore + k_rod + stop.slope + friction_slope + mount_slope;
    return CalcPressureForce(sys_, *at_, cylinder_) + stop.force + friction - mount;
  }

 private:
  void Place(double y) {
    const double moved = y - at_->piston[cylinder_];
    at_->piston[cylinder_] = y;
    auto push = [&](int node, double volume) {
      if (node == kOpen) return;
      at_->pushed[node] += volume;
      at_->node[node] =
          SolveNode(sys_.nodes[node], at_->pushed[node], at_->ambient, state_, &at_->node[node]);
    };
    push(c_.bore, -c_.bore_area * moved);
    push(c_.rod, c_.rod_area * moved);
  }
  double FrictionOnly(double move) const {
    const FrictionPlace place = sys_.Place(*at_, cylinder_, state_);
    double z = 0;
    if (c_.bristle >= 0) z = c_.friction.Advance(h_, move / h_, state_[c_.bristle], place);
    return c_.friction.Calc(move / h_, z, place).force;
  }
  double FrictionAfter(double move, double* slope) const {
    const double nudge = std::max(1e-7 * std::abs(move), 1e-13);
    const double force = FrictionOnly(move);
    *slope = std::max((FrictionOnly(move + nudge) - force) / nudge, 0.0);
    return force;
  }

  const CompiledPhs& sys_;
  const CompiledCylinder& c_;
  double h_, x_end_;
  const double* state_;
  Instant* at_;
  int cylinder_;
  double start_;
};

double SolveMove(PistonBalance* balance, double guess) {
  double low = -INFINITY, high = INFINITY, move = guess;
  for (int i = 0; i < 80; ++i) {
    double slope;
    const double force = balance->Calc(move, &slope);
    if (force == 0) return move;
    (force > 0 ? high : low) = move;
    double next = move - force / slope;
    if (!(next > low && next < high)) {
      next = std::isfinite(low) && std::isfinite(high) ? 0.5 * (low + high) : move;
    } else if (i > 8 && std::isfinite(low) && std::isfinite(high)) {
      // Newton that circles around a kink: halve every other time.
      if (i % 2 == 0) next = 0.5 * (low + high);
    }
    const double change = std::abs(next - move);
    move = next;
    if (change <= 1e-15 + 1e-11 * std::abs(move)) break;
  }
  double slope;
  balance->Calc(move, &slope);
  return move;
}

}  // namespace

double CalcMountForce(const MountTerms& mount, double u, const MountCreep& q, double* slope) {
  const double e = mount.PlayFree(u);
  double force = mount.SpringForce(e, slope);
  for (int b = 0; b < MountTerms::kBranches; ++b) {
    force += mount.maxwell_stiffness_N_per_m[b] * (e - q[b]);
    *slope += mount.maxwell_stiffness_N_per_m[b];
  }
  if (e == 0) *slope = 0;
  return force;
}

double CalcMountEnergy(const MountTerms& mount, double u, const MountCreep& q) {
  const double e = mount.PlayFree(u);
  const double k = mount.stiffness_N_per_m * (e > 0 ? mount.tension_ratio : 1);
  double energy = 0.5 * k * e * e * (1 + 0.5 * mount.hardening_1_per_m2 * e * e);
  for (int b = 0; b < MountTerms::kBranches; ++b) {
    energy += 0.5 * mount.maxwell_stiffness_N_per_m[b] * (e - q[b]) * (e - q[b]);
  }
  return energy;
}

double CalcMountLoss(const CompiledPhs& sys, const double* state) {
  double lost = 0;
  for (const CompiledCylinder& c : sys.cylinders) {
    for (int k = 0; k < MountTerms::kBranches; ++k) {
      if (c.maxwell[k] < 0) continue;
      const double e = c.mount.PlayFree(state[c.mount_state]);
      const double force = c.mount.maxwell_stiffness_N_per_m[k] * (e - state[c.maxwell[k]]);
      lost += force * force / c.mount.maxwell_damping_Ns_per_m[k];
    }
  }
  return lost;
}

void CalcMountRates(const CompiledPhs& sys, double time, double h, const double* x, const double* v,
                    const double* state, const Instant* near, double* piston_speed, double* rate) {
  const double step = std::max(h, kSmallestStep);
  const int count = static_cast<int>(sys.cylinders.size());
  Instant at;
  at.time = time + step;
  at.ambient = sys.Ambient(time + step);
  double start[kMaxCylinders], move[kMaxCylinders];
  for (int i = 0; i < count; ++i) {
    const CompiledCylinder& c = sys.cylinders[i];
    start[i] = x[i] - (c.mount_state >= 0 ? state[c.mount_state] : 0);
    move[i] = c.mount_state >= 0 ? 0 : v[i] * step;
    at.piston[i] = start[i] + move[i];
  }
  sys.CalcPushed(state, &at);
  sys.SolveNodes(state, &at, near);
  for (int sweep = 0; sweep < 60; ++sweep) {
    double largest = 0;
    int mounted = 0;
    for (int i = 0; i < count; ++i) {
      if (sys.cylinders[i].mount_state < 0) continue;
      ++mounted;
      // Start of the step as origin, whatever the sweep has moved so far.
      Instant here = at;
      const CompiledCylinder& c = sys.cylinders[i];
      here.piston[i] = start[i];
      if (c.bore != kOpen) here.pushed[c.bore] += c.bore_area * move[i];
      if (c.rod != kOpen) here.pushed[c.rod] -= c.rod_area * move[i];
      PistonBalance balance(sys, step, x[i] + v[i] * step, i, state, &here);
      const double next = SolveMove(&balance, sweep == 0 ? v[i] * step : move[i]);
      largest = std::max(largest, std::abs(next - move[i]));
      move[i] = next;
      at = here;
    }
    if (mounted == 1 || largest <= 1e-14) break;
  }
  for (int i = 0; i < count; ++i) {
    const CompiledCylinder& c = sys.cylinders[i];
    if (c.mount_state < 0) continue;
    piston_speed[i] = move[i] / step;
    rate[c.mount_state] = v[i] - piston_speed[i];
    const double u = state[c.mount_state] + step * rate[c.mount_state];
    const double e = c.mount.PlayFree(u);
    for (int k = 0; k < MountTerms::kBranches; ++k) {
      if (c.maxwell[k] < 0) continue;
      const double speed =
          c.mount.maxwell_stiffness_N_per_m[k] / c.mount.maxwell_damping_Ns_per_m[k];
      rate[c.maxwell[k]] = speed * (e - state[c.maxwell[k]]) / (1 + step * speed);
    }
  }
}

}  // namespace phs::hydraulics
