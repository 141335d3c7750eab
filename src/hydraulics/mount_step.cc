// How pistons move behind mountings that yield (mount_law.h): u = x - y is a state. The piston has
// no mass worth a state: F = pressure force + end stop + friction(dy/dt), which is solved for the
// pistons' ways over the step (mount_balance.h). Oil flows meanwhile (flow_stage.h). Several
// pistons, and a body that carries their driven ends, are moved at once; should that not end, the
// pistons are swept, one at a time, until none moves any more.
#include <algorithm>
#include <cmath>

#include "hydraulics/flow_stage.h"
#include "hydraulics/mount_balance.h"

namespace phs::hydraulics {
namespace {

constexpr double kSmallestStep = 1e-7;  // [s] stands for "now" in instantaneous rates

// No path lets oil pass: each chamber answers for itself.
class ClosedChambers final : public ChamberPressures {
 public:
  ClosedChambers(const MountStep& step, double time, const Instant* near) : step_(step) {
    step.sys.SetTime(time, &at_);
    for (size_t n = 0; n < step.sys.nodes.size(); ++n) {
      at_.node[n] = near != nullptr ? near->node[n] : NodeState{};
    }
  }

  void Solve(const double* way) override {
    for (size_t i = 0; i < step_.sys.cylinders.size(); ++i) {
      at_.piston[i] = step_.PistonAtStart(static_cast<int>(i)) + way[i];
    }
    step_.sys.CalcPushed(step_.state, &at_);
    step_.sys.SolveNodes(step_.state, &at_, &at_);
  }
  void Stiffness(const int* moved, int count, double (*of_each)[kMaxCylinders]) const override {
    for (int m = 0; m < count; ++m) {
      const CompiledCylinder& c = step_.sys.cylinders[moved[m]];
      for (size_t i = 0; i < step_.sys.cylinders.size(); ++i) {
        const CompiledCylinder& other = step_.sys.cylinders[i];
        double& k = of_each[m][i] = 0;
        // Both chambers of one line: what the one presses in the other gives back.
        const auto add = [&](int node, double area, int end, double there) {
          if (node != kOpen && node == end) k += area * there / at_.node[node].slope;
        };
        add(c.bore, -c.bore_area, other.bore, -other.bore_area);
        add(c.bore, -c.bore_area, other.rod, other.rod_area);
        add(c.rod, c.rod_area, other.bore, -other.bore_area);
        add(c.rod, c.rod_area, other.rod, other.rod_area);
      }
    }
  }
  const Instant& at() const override { return at_; }

 private:
  const MountStep& step_;
  Instant at_;
};

// Oil flows while the piston moves, by backward Euler: were it held back until the way is known,
// a small chamber behind a resistance would throw the piston back.
class FlowingChambers final : public ChamberPressures {
 public:
  FlowingChambers(const MountStep& step, double time, const Instant& start)
      : step_(step), time_(time), start_(start), inertances_(OwnInertances(step.sys)) {
    Begin();
  }

  /// To the end each time: what the stages of large ways contracted by says nothing of small ones,
  /// and what was left, 10 Pa, sent Newton's method of the ways in circles.
  void Solve(const double* way) override {
    for (size_t i = 0; i < step_.sys.cylinders.size(); ++i) {
      motion_.way[i] = way[i], motion_.speed[i] = way[i] / step_.h;
    }
    // From where the last ways led, or else from the step's start.
    if (!SolveFromHere()) {
      Begin();
      SolveFromHere();
    }
  }
  void Stiffness(const int* moved, int count, double (*of_each)[kMaxCylinders]) const override {
    CalcStageStiffness(step_.sys, inertances_, step_.h, at_, slopes_, moved, count, of_each);
  }
  const Instant& at() const override { return at_; }

 private:
  void Begin() {
    at_ = start_;
    at_.time = time_;
    if (step_.sys.extra) step_.sys.extra->At(time_, at_.extra);
    std::copy(step_.state, step_.state + step_.sys.num_states(), end_);
  }
  bool SolveFromHere() {
    double rate[kMaxStates];
    StageMemory none;
    return SolveStage(step_.sys, inertances_, time_, step_.h, start_, motion_, step_.state, end_,
                      rate, &at_, &lags_, &none, &slopes_);
  }

  const MountStep& step_;
  const double time_;
  const Instant& start_;
  const PathInertances inertances_;
  double end_[kMaxStates];
  Instant at_;
  StageLags lags_;
  StageMotion motion_;
  PathSlopes slopes_;
};

int CountMounted(const CompiledPhs& sys) {
  return static_cast<int>(
      std::count_if(sys.cylinders.begin(), sys.cylinders.end(),
                    [](const CompiledCylinder& c) { return c.mount_state >= 0; }));
}

/// One piston after the other, until none moves any more.
void Sweep(const MountStep& step, ChamberPressures* chambers, double* way) {
  const int count = static_cast<int>(step.sys.cylinders.size());
  const bool alone = CountMounted(step.sys) == 1;
  for (int sweep = 0; sweep < 60; ++sweep) {
    double largest = 0;
    for (int i = 0; i < count; ++i) {
      if (!step.IsMounted(i)) continue;
      const double before = way[i];
      BalancePiston(step, i, chambers, way);
      largest = std::max(largest, std::abs(way[i] - before));
    }
    if (alone || largest <= 1e-14) return;
  }
}

/// Calls work(chambers) with those of the step.
template <typename Work>
auto WithChambers(const MountStep& step, double time, const Instant* near, const Work& work) {
  const double end = time + step.h;
  if (step.sys.paths.empty()) return work(ClosedChambers(step, end, near));
  return work(FlowingChambers(step, end, *near));
}

}  // namespace

bool BalanceBody(const CompiledPhs& sys, double time, double h, const double* x, const double* v,
                 const double* state, const Instant* near, const CarriedBody& body,
                 double* piston_way, double* body_way) {
  const MountStep step{sys, h, x, v, state};
  for (size_t i = 0; i < sys.cylinders.size(); ++i) {
    if (!step.IsMounted(static_cast<int>(i))) piston_way[i] = v[i] * h;
  }
  return WithChambers(step, time, near, [&](ChamberPressures&& chambers) {
    return BalanceAll(step, &body, &chambers, piston_way, body_way);
  });
}

void CalcMountRates(const CompiledPhs& sys, double time, double h, const double* x, const double* v,
                    const double* state, const Instant* near, double* piston_speed, double* rate,
                    double* piston_way) {
  const MountStep step{sys, std::max(h, kSmallestStep), x, v, state};
  const int count = static_cast<int>(sys.cylinders.size());
  double way[kMaxCylinders];
  for (int i = 0; i < count; ++i) {
    way[i] = step.IsMounted(i) && piston_way != nullptr ? piston_way[i] : v[i] * step.h;
  }
  WithChambers(step, time, near, [&](ChamberPressures&& chambers) {
    const bool together =
        CountMounted(sys) > 1 && BalanceAll(step, nullptr, &chambers, way, nullptr);
    if (!together) Sweep(step, &chambers, way);
  });
  for (int i = 0; i < count; ++i) {
    const CompiledCylinder& c = sys.cylinders[i];
    if (c.mount_state < 0) continue;
    if (piston_way != nullptr) piston_way[i] = way[i];
    piston_speed[i] = way[i] / step.h;
    rate[c.mount_state] = v[i] - piston_speed[i];
    const double u = state[c.mount_state] + step.h * rate[c.mount_state];
    c.mount.CalcRates(u, c.Branches(state), step.h, rate + c.mount_state + 1);
  }
}

}  // namespace phs::hydraulics
