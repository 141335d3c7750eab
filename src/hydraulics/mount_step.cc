// How pistons move behind mountings that yield (mount_law.h): u = x - y is a state. The piston has
// no mass worth a state: F = pressure force + end stop + friction(dy/dt), which is solved for the
// piston's move over the step by backward Euler. The sum rises with the move, so a bracketed Newton
// finds it. Oil flows meanwhile (flow_stage.h). Pistons that share lines stand in one convex
// potential of their moves: where oil flows all are moved at once, by Newton's method with a search
// along its way; else, or should that not end, they are swept, one at a time, until none moves any
// more.
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

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
    const PathSlopes slopes = Solve();
    double of_each[1][kMaxCylinders];
    Stiffness(slopes, &cylinder_, 1, of_each);
    *slope = of_each[0][cylinder_];
    return CalcPressureForce(sys_, at_, cylinder_);
  }
  const Instant& at() const override { return at_; }
  void Move(int cylinder, double way) {
    motion_.way[cylinder] = way, motion_.speed[cylinder] = way / h_;
  }
  /// The stage at the moves. To the end each time: what the stages of large moves contracted by says
  /// nothing of small ones, and what was left, 10 Pa, sent Newton's method of the moves in circles.
  PathSlopes Solve() {
    double rate[kMaxStates];
    PathSlopes slopes;
    StageMemory none;
    SolveStage(sys_, inertances_, time_ + h_, h_, start_, motion_, state_, end_, rate, &at_, &lags_,
               &none, &slopes);
    return slopes;
  }
  /// d(pressure force of each piston)/d(way of those moved) there.
  void Stiffness(const PathSlopes& slopes, const int* moved, int count,
                 double (*of_each)[kMaxCylinders]) const {
    CalcStageStiffness(sys_, inertances_, h_, at_, slopes, moved, count, of_each);
  }

 private:
  const double time_, h_;
  const Instant& start_;
  const double* state_;
  const PathInertances inertances_;
  double* end_;
  Instant& at_;
  StageLags lags_;
  StageMotion motion_;
};

// What holds one piston beside its pressures, when it moves by `move` during h: rises with `move`.
class PistonHold {
 public:
  PistonHold(const CompiledPhs& sys, double h, double start, double x_end, int cylinder,
             const double* state)
      : sys_(sys),
        c_(sys.cylinders[cylinder]),
        h_(h),
        start_(start),
        x_end_(x_end),
        state_(state),
        cylinder_(cylinder) {}

  /// `at`: pressures at the end of the step.
  double Calc(const Instant& at, double move, double* slope) const {
    double friction_slope, mount_slope;
    const EndStopForce stop = CalcEndStop(c_.stop, start_ + move, move / h_);
    const double friction = FrictionAfter(at, move, &friction_slope);
    const double mount =
        c_.mount.Force(x_end_ - start_ - move, c_.Branches(state_), h_, &mount_slope);
    *slope = stop.slope + friction_slope + mount_slope;
    return stop.force + friction - mount;
  }

 private:
  double FrictionOnly(const Instant& at, double move) const {
    const FrictionPlace place = sys_.Place(at, cylinder_, state_);
    double z = 0;
    if (c_.bristle >= 0) z = c_.friction.Advance(h_, move / h_, state_[c_.bristle], place);
    return c_.friction.Calc(move / h_, z, place).force;
  }
  double FrictionAfter(const Instant& at, double move, double* slope) const {
    const double nudge = std::max(1e-7 * std::abs(move), 1e-13);
    const double force = FrictionOnly(at, move);
    *slope = std::max((FrictionOnly(at, move + nudge) - force) / nudge, 0.0);
    return force;
  }

  const CompiledPhs& sys_;
  const CompiledCylinder& c_;
  double h_, start_, x_end_;
  const double* state_;
  int cylinder_;
};

/// How well a move over h is met. What friction makes of an error goes with its speed: 1e-12 m over
/// 5 ms, 0.01 Pa in a chamber.
double Enough(double h) { return std::max(1e-15, 2e-10 * h); }

/// The move over h that balances, the last that the balance was calculated at.
double SolveMove(const PistonHold& hold, ChamberPressures* chambers, double h, double guess) {
  const double enough = Enough(h);
  double low = -INFINITY, high = INFINITY, move = guess;
  for (int i = 0;; ++i) {
    double of_pressure, of_rest;
    const double pressure = chambers->Calc(move, &of_pressure);
    const double force = pressure + hold.Calc(chambers->at(), move, &of_rest);
    const double slope = of_pressure + of_rest;
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

/// All pistons behind mountings at once.
class JointBalance {
 public:
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxCylinders, 1>;
  using Matrix =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxCylinders, kMaxCylinders>;

  JointBalance(const CompiledPhs& sys, FlowingChambers* chambers)
      : sys_(sys), chambers_(*chambers) {}
  void Add(int cylinder, const PistonHold& hold) {
    cylinder_[count_] = cylinder;
    hold_[count_++].emplace(hold);
  }

  /// Moves for which all balance, from `move`; none where Newton's method does not end.
  std::optional<Vector> Solve(Vector move, double enough) {
    Matrix slopes;
    Vector force = Calc(move, &slopes);
    for (int i = 0; i < 40; ++i) {
      const Vector way = slopes.ldlt().solve(-force);
      if (!way.allFinite()) return {};
      if (way.lpNorm<Eigen::Infinity>() <= enough) return move;
      // Along the way the potential falls at first; past its lowest point it rises.
      const double falls = way.dot(force);
      double low = 0, high = 1, at_low = falls, share = 1;
      Vector next = move + way;
      Vector there = Calc(next, &slopes);
      for (int k = 0; k < 20; ++k) {
        const double rises = way.dot(there);
        if (std::abs(rises) <= 0.5 * std::abs(falls)) break;
        if (rises < 0 && share == 1) break;  // Newton's own step, still falling
        if (rises > 0) {
          high = share;
        } else {
          low = share, at_low = rises;
        }
        const double secant = low + (share - low) * at_low / (at_low - rises);
        share = rises > 0 && secant > low && secant < high ? secant : 0.5 * (low + high);
        share = std::clamp(share, low + 0.05 * (high - low), high - 0.05 * (high - low));
        next = move + share * way;
        there = Calc(next, &slopes);
      }
      move = next, force = there;
    }
    return {};
  }

 private:
  Vector Calc(const Vector& move, Matrix* slopes) {
    for (int i = 0; i < count_; ++i) chambers_.Move(cylinder_[i], move[i]);
    const PathSlopes path_slopes = chambers_.Solve();
    Vector force(count_);
    slopes->resize(count_, count_);
    double of_each[kMaxCylinders][kMaxCylinders];
    chambers_.Stiffness(path_slopes, cylinder_.data(), count_, of_each);
    for (int i = 0; i < count_; ++i) {
      double of_rest;
      for (int k = 0; k < count_; ++k) (*slopes)(k, i) = of_each[i][cylinder_[k]];
      force[i] = CalcPressureForce(sys_, chambers_.at(), cylinder_[i]) +
                 hold_[i]->Calc(chambers_.at(), move[i], &of_rest);
      (*slopes)(i, i) += of_rest;
    }
    *slopes = 0.5 * (*slopes + slopes->transpose().eval());
    return force;
  }

  const CompiledPhs& sys_;
  FlowingChambers& chambers_;
  int count_ = 0;
  std::array<int, kMaxCylinders> cylinder_;
  std::array<std::optional<PistonHold>, kMaxCylinders> hold_;
};

/// The moves of all pistons at once; false where Newton's method does not end.
bool MoveTogether(const CompiledPhs& sys, double h, const double* start, const double* x,
                  const double* v, const double* state, FlowingChambers* chambers, double* move) {
  JointBalance balance(sys, chambers);
  JointBalance::Vector guess(static_cast<Eigen::Index>(sys.cylinders.size()));
  int mounted = 0;
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    if (sys.cylinders[i].mount_state < 0) continue;
    const int cylinder = static_cast<int>(i);
    balance.Add(cylinder, PistonHold(sys, h, start[i], x[i] + v[i] * h, cylinder, state));
    guess[mounted++] = v[i] * h;
  }
  guess.conservativeResize(mounted);
  const auto found = balance.Solve(guess, Enough(h));
  if (!found) return false;
  int next = 0;
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    if (sys.cylinders[i].mount_state >= 0) move[i] = (*found)[next++];
  }
  return true;
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
  const auto mounted = std::count_if(sys.cylinders.begin(), sys.cylinders.end(),
                                     [](const CompiledCylinder& c) { return c.mount_state >= 0; });
  bool together = false;
  if (flowing && mounted > 1) {
    constexpr int kNoneAlone = 0;  // whose chambers they are counts where one is solved for
    FlowingChambers chambers(sys, time, step, kNoneAlone, *near, state, move, end, &at);
    together = MoveTogether(sys, step, start, x, v, state, &chambers, move);
  }
  for (int sweep = 0; sweep < 60 && !together; ++sweep) {
    double largest = 0;
    for (int i = 0; i < count; ++i) {
      if (sys.cylinders[i].mount_state < 0) continue;
      const PistonHold hold(sys, step, start[i], x[i] + v[i] * step, i, state);
      const auto solve = [&](ChamberPressures&& chambers) {
        return SolveMove(hold, &chambers, step, sweep == 0 ? v[i] * step : move[i]);
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
