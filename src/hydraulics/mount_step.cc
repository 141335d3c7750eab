// How pistons move behind mountings that yield (mount_law.h): u = x - y is a state. The piston has
// no mass worth a state: F = pressure force + end stop + friction(dy/dt), which is solved for the
// piston's move over the step by backward Euler. The sum rises with the move, so a bracketed Newton
// finds it; cylinders that share lines are swept until none moves any more (descent in one convex
// potential, one block at a time). Oil flows meanwhile (flow_stage.h).
#include <algorithm>
#include <cmath>

#include "hydraulics/compiled_phs.h"
#include "hydraulics/flow_stage.h"
#include "hydraulics/solve_node.h"

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
    SolveNodeAt(sys_.nodes[node], at_.pushed[node], at_.ambient, state_, &at_.node[node]);
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
    SolveStage(sys_, inertances_, time_ + h_, h_, start_, motion_, state_, end_, rate, &at_, &lags_,
               &memory_, &slopes);
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
  StageLags lags_;
  StageMemory memory_;
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
    const double mount =
        c_.mount.Force(x_end_ - start_ - move, c_.Branches(state_), h_, &mount_slope);
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

/// The move over h that balances, the last that the balance was calculated at. What friction makes
/// of an error goes with its speed: 1e-12 m over 5 ms, 0.01 Pa in a chamber.
double SolveMove(PistonBalance* balance, double h, double guess) {
  const double enough = std::max(1e-15, 2e-10 * h);
  double low = -INFINITY, high = INFINITY, move = guess;
  for (int i = 0;; ++i) {
    double slope;
    const double force = balance->Calc(move, &slope);
    if (std::abs(force) <= enough * slope) break;
    (force > 0 ? high : low) = move;
    double next = move - force / slope;
    const bool between = std::isfinite(low) && std::isfinite(high);
    if (!(next > low && next < high)) {
      next = between ? 0.5 * (low + high) : move;
    } else if (i > 8 && between && i % 2 == 0) {
      next = 0.5 * (low + high);  // Newton that circles around a kink
    }
    if (std::abs(next - move) <= enough || i == 80) break;
    move = next;
  }
  return move;
}

}  // namespace

void CalcMountRates(const CompiledPhs& sys, double time, double h, const double* x, const double* v,
                    const double* state, const Instant* near, double* piston_speed, double* rate) {
  const double step = std::max(h, kSmallestStep);
  const int count = static_cast<int>(sys.cylinders.size());
  const bool flowing = !sys.paths.empty();
  Instant at;
  sys.SetTime(time + step, &at);
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
    if (sys.extra) sys.extra->At(time + step, at.extra);
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
        return SolveMove(&balance, step, sweep == 0 ? v[i] * step : move[i]);
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
    c.mount.CalcRates(u, c.Branches(state), step, rate + c.mount_state + 1);
  }
}

}  // namespace phs::hydraulics
