#include "rigs/rig_cylinder.h"

#include <algorithm>
#include <cmath>

namespace phs::rigs {

using hydraulics::PhsOutputs;
using hydraulics::PhsSystem;

namespace {

/// Position between two samples: the cubic through both with their speeds.
class SampleStep {
 public:
  SampleStep(double x0, double x1, double v0, double v1, double h)
      : x0_(x0), x1_(x1), v0_(h * v0), v1_(h * v1) {}
  double At(double s) const {
    const double d = x1_ - x0_;
    return x0_ + s * (v0_ + s * (3 * d - 2 * v0_ - v1_ + s * (v0_ + v1_ - 2 * d)));
  }
  double End() const { return x1_; }
  /// dx/ds.
  double Slope(double s) const {
    const double d = x1_ - x0_;
    return v0_ + s * (2 * (3 * d - 2 * v0_ - v1_) + s * 3 * (v0_ + v1_ - 2 * d));
  }
  /// Where between `from` and `to` the motion turns; `to` if it does not (or twice).
  double Turn(double from, double to) const {
    if (Slope(from) * Slope(to) >= 0) return to;
    const double d = x1_ - x0_, half = 3 * d - 2 * v0_ - v1_, third = 3 * (v0_ + v1_ - 2 * d);
    const double q = -(half + std::copysign(std::sqrt(half * half - third * v0_), half));
    const double other = v0_ / q;
    return other > from && other < to ? other : std::clamp(q / third, from, to);
  }

 private:
  double x0_, x1_, v0_, v1_;
};

/// One step of the integration of a driven cylinder.
struct RigStep {
  double time = 0, length = 0;  ///< [s]; no length after the last sample
  double x = 0, v = 0;          ///< position at its start [m], mean speed [m/s]
  int sample = 0;
  bool first = false;  ///< starts at the sample itself
  double turn_s = 0;   ///< time after its start at which the motion turns; `length` if it does not
  double turn_x = 0;   ///< position there [m]
  double v_end = 0;    ///< speed at its end [m/s]
};

/// Calls visit(step) along the motion, `substeps` to a sample and a last one of no length.
template <typename Visit>
void WalkSteps(const RigMotion& motion, const std::vector<double>& speed, int substeps,
               const Visit& visit) {
  const int n = motion.num_samples();
  const double h = motion.step_s / substeps;
  for (int i = 0; i < n; ++i) {
    RigStep at{motion.t0_s + i * motion.step_s, h, motion.position_m[0][i], 0, i, true};
    if (i + 1 == n) {
      at.length = 0, at.v = at.v_end = speed[i];
      visit(at);
      return;
    }
    const SampleStep step(motion.position_m[0][i], motion.position_m[0][i + 1], speed[i],
                          speed[i + 1], motion.step_s);
    for (int k = 0; k < substeps; ++k) {
      const double from = double(k) / substeps, to = (k + 1.0) / substeps;
      const double next = k + 1 < substeps ? step.At(to) : step.End();
      const double turn = step.Turn(from, to);
      at.v = (next - at.x) / h, at.first = k == 0;
      at.v_end = step.Slope(to) / motion.step_s;
      at.turn_s = turn < to ? (turn - from) * motion.step_s : h;
      at.turn_x = turn < to ? step.At(turn) : next;
      visit(at);
      at.time += h, at.x = next;
    }
  }
}

/// Those asked for, or as many as a ringing oil column needs. What rings far faster than the most
/// steps can follow is damped away by one step as by these.
int Substeps(const PhsSystem& system, const RigOptions& options, double step_s) {
  constexpr double kPhase = 0.6;  // [rad] per step: numerical damping below 0.1 %
  constexpr double kFollowed = 3;
  const double needed = std::ceil(system.max_line_frequency() * step_s / kPhase);
  if (needed > kFollowed * options.most_substeps) return options.substeps;
  return std::max(options.substeps,
                  static_cast<int>(std::min<double>(needed, options.most_substeps)));
}

/// Outputs that are written to the channels of one sample; the force is left to the caller.
PhsOutputs AtSample(int sample, RigPrediction* out) {
  const auto i = static_cast<size_t>(sample);
  PhsOutputs at;
  at.energy = false;
  at.piston = &out->channels[0][i];
  at.p_bore = &out->channels[2][i];
  at.p_rod = &out->channels[3][i];
  return at;
}

KeptRun CalcPressures(const PhsSystem& system, const RigMotion& motion,
                      const std::vector<double>& speed, int substeps) {
  const int states = system.num_states();
  std::vector<double> state(states, 0.0), rate(states, 0.0);
  hydraulics::Instant instant;
  KeptRun out;
  const auto steps = static_cast<size_t>(motion.num_samples()) * static_cast<size_t>(substeps);
  out.bore.reserve(steps), out.rod.reserve(steps);
  WalkSteps(motion, speed, substeps, [&](const RigStep& at) {
    double bore, rod;
    system.CalcHydraulics(at.time, at.length, &at.x, {&at.v, &at.v_end}, state.data(), &instant,
                          rate.data(), &bore, &rod);
    out.bore.push_back(bore), out.rod.push_back(rod);
    for (int j = system.num_friction_states(); j < states; ++j) state[j] += at.length * rate[j];
  });
  return out;
}

// Rigid mountings: friction and load cell from the pressures of the walk with the same steps. A
// bristle turns where the motion turns: a step in which it does is taken in two, or the way beyond
// the samples were lost (some micrometres, as much as a stiff bristle takes to turn).
void RunRigid(const PhsSystem& system, int substeps, const RigMotion& motion,
              const std::vector<double>& speed, const KeptRun& pressures, RigPrediction* out) {
  const int friction_states = system.num_friction_states();
  std::vector<double> state(system.num_states(), 0.0), rate(state);
  const double* bore = pressures.bore.data();
  const double* rod = pressures.rod.data();
  WalkSteps(motion, speed, substeps, [&](const RigStep& at) {
    if (at.first) {
      PhsOutputs sample = AtSample(at.sample, out);
      sample.force = &out->channels[1][at.sample];
      system.CalcForces(at.time, &at.x, &speed[at.sample], state.data(), bore, rod, &sample);
    }
    const auto slide = [&](double time, double length, double x, double way) {
      if (length <= 0) return;
      const double v = way / length;
      system.CalcFrictionRate(time, length, &x, &v, state.data(), bore, rod, rate.data());
      for (int j = 0; j < friction_states; ++j) state[j] += length * rate[j];
    };
    if (friction_states > 0) {
      slide(at.time, at.turn_s, at.x, at.turn_x - at.x);
      slide(at.time + at.turn_s, at.length - at.turn_s, at.turn_x,
            at.x + at.length * at.v - at.turn_x);
    }
    ++bore, ++rod;
  });
}

// Yielding mountings in steps that are cut finer than the samples.
void RunStepped(const PhsSystem& system, int substeps, const RigMotion& motion,
                const std::vector<double>& speed, RigPrediction* out) {
  std::vector<double> state(system.num_states(), 0.0), rate(state);
  WalkSteps(motion, speed, substeps, [&](const RigStep& at) {
    if (at.first) {
      PhsOutputs sample = AtSample(at.sample, out);
      sample.force = &out->channels[1][at.sample];
      system.Calc(at.time, &at.x, &speed[at.sample], state.data(), &sample);
    }
    if (at.length == 0) return;
    system.CalcStateRate(at.time, at.length, &at.x, &at.v, state.data(), rate.data());
    for (size_t j = 0; j < state.size(); ++j) state[j] += at.length * rate[j];
  });
}

/// What a yielding mounting shows at one instant.
struct MountedPlace {
  double piston = 0;                     ///< [m]
  double force = 0, pressure_force = 0;  ///< [N]
  double p_bore = 0, p_rod = 0;          ///< [Pa]
};

MountedPlace CalcMounted(const PhsSystem& system, double t, double x, double v,
                         const std::vector<double>& state) {
  MountedPlace at;
  PhsOutputs out;
  out.energy = false;
  out.force = &at.force, out.pressure_force = &at.pressure_force, out.piston = &at.piston;
  out.p_bore = &at.p_bore, out.p_rod = &at.p_rod;
  system.Calc(t, &x, &v, state.data(), &out);
  return at;
}

/// Pressures at a sample half a step after an end of one: the oil goes on from there behind a
/// piston whose place at both is known, by the stages of a step of its own (flow_rates.cc).
/// `from`: driven end at that end of the step [m]; `speed`: of the piston at the sample [m/s].
MountedPlace FlowToSample(const PhsSystem& system, double t, double half, double from,
                          const MountedPlace& start, double piston, double speed,
                          std::vector<double> state) {
  std::vector<double> rate(state.size(), 0.0);
  const double mean = (piston - start.piston) / half, given = from - start.piston;
  hydraulics::Instant instant;
  double bore, rod;
  system.CalcHydraulics(t, half, &from, {&mean, &speed}, state.data(), &instant, rate.data(), &bore,
                        &rod);
  for (size_t j = static_cast<size_t>(system.num_friction_states()); j < state.size(); ++j) {
    state[j] += half * rate[j];
  }
  return CalcMounted(system, t + half, piston + given, speed, state);
}

// A yielding mount: the piston's speed is that of a step, so steps are laid about the samples, from
// middle to middle. Friction then belongs to the speed at the sample (to second order), and the
// state is taken there as the mean of the step's two ends. Were the steps laid from sample to
// sample, friction would lag by half a step, some hundred newtons about a reversal.
// Pressures at the sample are those of that state; where oil flows or gas warms, those after the
// half step to it: in a small chamber the mean of a flow that hardly bends moves them far.
void RunMounted(const PhsSystem& system, const RigMotion& motion, const std::vector<double>& speed,
                RigPrediction* out) {
  const int n = motion.num_samples(), states = system.num_states();
  const double h = motion.step_s;
  const bool slow = states > system.num_friction_states();
  const std::vector<double>& x = motion.position_m[0];
  std::vector<double> state(states, 0.0), middle(states), rate(states, 0.0);
  MountedPlace start = CalcMounted(system, motion.t0_s, x[0], 0, state);
  double from = x[0], t = motion.t0_s, piston_speed = 0;
  for (int i = 0; i < n; ++i) {
    // Cubic through both samples with their speeds, half way; straight on after the last.
    const double to = i + 1 < n ? 0.5 * (x[i] + x[i + 1]) + h / 8 * (speed[i] - speed[i + 1])
                                : x[i] + 0.5 * h * speed[i];
    const double step = i == 0 ? 0.5 * h : h, v = (to - from) / step;
    system.CalcStateRate(t, step, &from, &v, state.data(), rate.data(),
                         i > 1 ? &piston_speed : nullptr);
    const std::vector<double> before = state;
    for (int j = 0; j < states; ++j) {
      middle[j] = state[j] + (i == 0 ? 0.0 : 0.5 * step * rate[j]);
      state[j] += step * rate[j];
    }
    const MountedPlace end = CalcMounted(system, t + step, to, v, state);
    piston_speed = (end.piston - start.piston) / step;
    MountedPlace at = CalcMounted(system, motion.t0_s + i * h, x[i], speed[i], middle);
    const double piston = at.piston;
    if (i > 0 && slow) {
      at = FlowToSample(system, t, 0.5 * h, from, start, piston, piston_speed, before);
    }
    out->channels[0][i] = piston;
    // Friction and end stop as at the sample: what the mounting held against the pressures that the
    // piston was moved by, those of the gas as warm as it was.
    double pushed = end.pressure_force;
    if (slow && !system.has_flows()) {
      std::vector<double> as_warm = state;
      std::copy(before.begin() + system.num_friction_states(), before.end(),
                as_warm.begin() + system.num_friction_states());
      pushed = CalcMounted(system, t + step, to, v, as_warm).pressure_force;
    }
    out->channels[1][i] = at.pressure_force + (end.force - pushed);
    out->channels[2][i] = at.p_bore, out->channels[3][i] = at.p_rod;
    t += step, from = to, start = end;
  }
}

}  // namespace

void RunCylinder(const PhsSystem& system, const RigOptions& options, const RigMotion& motion,
                 const std::vector<double>& speed, std::shared_ptr<const KeptRun>* pressures,
                 RigPrediction* out) {
  const int finer = Substeps(system, options, motion.step_s);
  if (system.has_mounts()) {
    return options.substeps == 1 ? RunMounted(system, motion, speed, out)
                                 : RunStepped(system, finer, motion, speed, out);
  }
  if (*pressures == nullptr) {
    *pressures = std::make_shared<const KeptRun>(CalcPressures(system, motion, speed, finer));
  }
  RunRigid(system, finer, motion, speed, **pressures, out);
}

void RunAtPressures(const PhsSystem& system, const RigMotion& motion,
                    const std::vector<double>& speed, const KeptRun& pressures,
                    RigPrediction* out) {
  RunRigid(system, 1, motion, speed, pressures, out);
}

}  // namespace phs::rigs
