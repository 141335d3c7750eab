// What lies between mounting and piston: free play in series with a spring and a Maxwell branch.
//
//   x o--[ gap ]--+--[ k ]-------------+--o y piston
//                 +--[ k2 ]--q--[ c ]--+  (one or two)
//   u = x - y (state), e = u beyond the play:
//   e = u - s gap above s gap, u + (1-s) gap below -(1-s) gap, 0 between; s = 1/2: in the middle
//   F = k e (1 + b e²) [times r for e > 0] + sum k2 (e - q)
//   dq/dt = k2 (e - q)/c
// The piston has no mass worth a state: F = pressure force + end stop + friction(dy/dt), which is
// solved for the piston's move over the step by backward Euler. The sum rises with the move, so a
// bracketed Newton finds it; cylinders that share lines are swept until none moves any more
// (descent in one convex potential, one block at a time). Oil flows meanwhile (flow_stage.h).
#include <algorithm>
#include <cmath>

#include "hydraulics/flow_stage.h"
#include "hydraulics/phs_impl.h"

namespace phs::hydraulics {
namespace {

constexpr double kSmallestStep = 1e-7;  // [s] stands for "now" in instantaneous rates

// Pressures at the end of a step as the pistons' ways over it make them.
class ChamberPressures {
 public:
  explicit ChamberPressures(const CompiledPhs& sys, int cylinder)
      : sys_(sys), cylinder_(cylinder) {}
  virtual ~ChamberPressures() = default;
  // Pressure force of the piston after `move` and its slope.
  virtual double Calc(double move, double* slope) = 0;
  virtual const Instant& at() const = 0;

 protected:
  const CompiledPhs& sys_;
  const int cylinder_;
};

// No path lets oil pass: each chamber answers for itself.
class ClosedChambers final : public ChamberPressures {
 public:
  ClosedChambers(const CompiledPhs& sys, int cylinder, const double* state, Instant* at)
      : ChamberPressures(sys, cylinder), state_(state), at_(*at), start_(at->piston[cylinder]) {}

  double Calc(double move, double* slope) override {
    const CompiledCylinder& c = sys_.cylinders[cylinder_];
    const double moved = start_ + move - at_.piston[cylinder_];
    at_.piston[cylinder_] = start_ + move;
    const double k_bore = Push(c.bore, -c.bore_area * moved, c.bore_area);
    *slope = k_bore + Push(c.rod, c.rod_area * moved, c.rod_area);
    return CalcPressureForce(sys_, at_, cylinder_);
  }
  const Instant& at() const override { return at_; }

 private:
  double Push(int node, double volume, double area) {
    if (node == kOpen) return 0;
    at_.pushed[node] += volume;
    at_.node[node] =
        SolveNode(sys_.nodes[node], at_.pushed[node], at_.ambient, state_, &at_.node[node]);
    return area * area / at_.node[node].slope;
  }

  const double* state_;
  Instant& at_;
  const double start_;
};

// Oil flows while the piston moves, by backward Euler: were it held back until the move is known,
// a small chamber behind a resistance would throw the piston back.
class FlowingChambers final : public ChamberPressures {
 public:
  FlowingChambers(const CompiledPhs& sys, double time, double h, int cylinder, const Instant& start,
                  const double* state, const double* move, double* end, Instant* at)
      : ChamberPressures(sys, cylinder),
        time_(time),
        h_(h),
        start_(start),
        state_(state),
        inertances_(OwnInertances(sys)),
        end_(end),
        at_(*at) {
    for (size_t i = 0; i < sys.cylinders.size(); ++i) Move(static_cast<int>(i), move[i]);
  }

  double Calc(double move, double* slope) override {
    Move(cylinder_, move);
    double rate[kMaxStates];
    PathSlopes slopes;
    SolveStage(sys_, inertances_, time_ + h_, h_, start_, motion_, state_, end_, rate, &at_,
               &slopes);
    *slope = CalcStageStiffness(sys_, inertances_, h_, at_, slopes, cylinder_);
    return CalcPressureForce(sys_, at_, cylinder_);
  }
  const Instant& at() const override { return at_; }

 private:
  void Move(int cylinder, double way) {
    motion_.way[cylinder] = way, motion_.speed[cylinder] = way / h_;
  }

  const double time_, h_;
  const Instant& start_;
  const double* state_;
  const PathInertances inertances_;
  double* end_;
  Instant& at_;
  StageMotion motion_;
};

// Force balance of one piston that moves by `move` during h: value rises with `move`.
class PistonBalance {
 public:
  PistonBalance(const CompiledPhs& sys, double h, double start, double x_end, int cylinder,
                const double* state, ChamberPressures* chambers)
      : sys_(sys),
        c_(sys.cylinders[cylinder]),
        h_(h),
        start_(start),
        x_end_(x_end),
        state_(state),
        chambers_(*chambers),
        cylinder_(cylinder) {}

  double Calc(double move, double* slope) {
    double pressure_slope, friction_slope, mount_slope;
    const double pressure = chambers_.Calc(move, &pressure_slope);
    const EndStopForce stop = CalcEndStop(c_.stop, start_ + move, move / h_);
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
    *slope = pressure_slope + stop.slope + friction_slope + mount_slope;
    return pressure + stop.force + friction - mount;
  }

 private:
  double FrictionOnly(double move) const {
    const FrictionPlace place = sys_.Place(chambers_.at(), cylinder_, state_);
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
  double h_, start_, x_end_;
  const double* state_;
  ChamberPressures& chambers_;
  int cylinder_;
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
  const bool flowing = !sys.paths.empty();
  Instant at;
  at.time = time + step;
  at.ambient = sys.Ambient(time + step);
  double start[kMaxCylinders], move[kMaxCylinders], end[kMaxStates];
  for (int i = 0; i < count; ++i) {
    const CompiledCylinder& c = sys.cylinders[i];
    start[i] = x[i] - (c.mount_state >= 0 ? state[c.mount_state] : 0);
    move[i] = c.mount_state >= 0 ? 0 : v[i] * step;
    at.piston[i] = start[i] + move[i];
  }
  if (flowing) {
    at = *near;
    at.time = time + step;
    std::copy(state, state + sys.num_states(), end);
  } else {
    sys.CalcPushed(state, &at);
    sys.SolveNodes(state, &at, near);
  }
  for (int sweep = 0; sweep < 60; ++sweep) {
    double largest = 0;
    int mounted = 0;
    for (int i = 0; i < count; ++i) {
      if (sys.cylinders[i].mount_state < 0) continue;
      ++mounted;
      const auto solve = [&](ChamberPressures&& chambers) {
        PistonBalance balance(sys, step, start[i], x[i] + v[i] * step, i, state, &chambers);
        return SolveMove(&balance, sweep == 0 ? v[i] * step : move[i]);
      };
      double next;
      if (flowing) {
        next = solve(FlowingChambers(sys, time, step, i, *near, state, move, end, &at));
      } else {
        // Start of the step as origin, whatever the sweep has moved so far.
        Instant here = at;
        const CompiledCylinder& c = sys.cylinders[i];
        here.piston[i] = start[i];
        if (c.bore != kOpen) here.pushed[c.bore] += c.bore_area * move[i];
        if (c.rod != kOpen) here.pushed[c.rod] -= c.rod_area * move[i];
        next = solve(ClosedChambers(sys, i, state, &here));
        at = here;
      }
      largest = std::max(largest, std::abs(next - move[i]));
      move[i] = next;
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
