#include "rigs/driven_rigs.h"

#include <cmath>

#include "rigs/implicit_move.h"

namespace phs::rigs {

using hydraulics::PhsOutputs;
using hydraulics::PhsSystem;

void RunPistons(const PhsSystem& system, const RigOptions& options, const RigMotion& motion,
                const std::vector<std::vector<double>>& speed, RigPrediction* out) {
  const auto cylinders = static_cast<size_t>(system.num_cylinders());
  const auto lines = static_cast<size_t>(system.num_lines());
  const double h = motion.step_s / options.substeps;
  std::vector<double> state(static_cast<size_t>(system.num_states()), 0.0), rate(state);
  std::vector<double> x(cylinders), v(cylinders), before(cylinders), piston(cylinders),
      force(cylinders), pressure(lines);
  PhsOutputs at;
  at.energy = false;
  at.piston = piston.data(), at.force = force.data(), at.pressure = pressure.data();
  bool first = true;
  for (int i = 0; i < motion.num_samples(); ++i) {
    const auto k = static_cast<size_t>(i);
    const double t = motion.t0_s + i * motion.step_s;
    for (size_t c = 0; c < cylinders; ++c) x[c] = motion.position_m[c][k], v[c] = speed[c][k];
    system.Calc(t, x.data(), v.data(), state.data(), &at);
    for (size_t c = 0; c < cylinders; ++c) {
      out->channels[c][k] = piston[c];
      out->channels[cylinders + c][k] = force[c];
    }
    for (size_t l = 0; l < lines; ++l) out->channels[2 * cylinders + l][k] = pressure[l];
    if (i + 1 == motion.num_samples()) continue;
    for (size_t c = 0; c < cylinders; ++c) {
      v[c] = (motion.position_m[c][k + 1] - x[c]) / motion.step_s;
    }
    for (int s = 0; s < options.substeps; ++s) {
      system.CalcStateRate(t + s * h, h, x.data(), v.data(), state.data(), rate.data(),
                           first || system.has_mounts() ? nullptr : before.data());
      for (size_t j = 0; j < state.size(); ++j) state[j] += h * rate[j];
      for (size_t c = 0; c < cylinders; ++c) x[c] += h * v[c];
      before = v, first = false;
    }
  }
}

namespace {

/// A cylinder with a mass on its moving end.
class DrivenMass {
 public:
  DrivenMass(const PhsSystem& system, double mass_kg)
      : system_(system),
        mass_(mass_kg),
        state_(static_cast<size_t>(system.num_states()), 0.0),
        rate_(state_),
        next_(state_) {}

  void Calc(double t, PhsOutputs* out) const { system_.Calc(t, &x_, &speed_, state_.data(), out); }

  /// Over h, `force` pulling at its end.
  void Step(double t, double h, double force) {
    hydraulics::Instant at;
    system_.Solve(t, &x_, state_.data(), &at);
    const double move = FindMove(speed_ * h, mass_ / (h * h), &guess_, [&](double trial) {
      const double v = trial / h, end = x_ + trial;
      system_.CalcStateRateAt(at, h, &x_, &v, state_.data(), rate_.data(),
                              system_.has_mounts() ? nullptr : &speed_);
      for (size_t j = 0; j < state_.size(); ++j) next_[j] = state_[j] + h * rate_[j];
      double held = 0;
      PhsOutputs out;
      out.energy = false;
      out.force = &held;
      system_.Calc(t + h, &end, &v, next_.data(), &out);
      return mass_ * (v - speed_) / h + held - force;
    });
    state_ = next_;
    speed_ = move / h;
    x_ += move;
  }

 private:
  const PhsSystem& system_;
  double mass_;
  double x_ = 0, speed_ = 0;
  MoveGuess guess_;
  std::vector<double> state_, rate_, next_;
};

}  // namespace

void RunForce(const PhsSystem& system, const RigOptions& options, const RigMotion& motion,
              RigPrediction* out) {
  const std::vector<double>& force = motion.position_m[0];
  const double h = motion.step_s / options.substeps;
  DrivenMass mass(system, options.moving_mass_kg);
  for (size_t i = 0; i < force.size(); ++i) {
    const double t = motion.t0_s + static_cast<double>(i) * motion.step_s;
    PhsOutputs at;
    at.energy = false;
    at.piston = &out->channels[0][i], at.force = &out->channels[1][i];
    at.p_bore = &out->channels[2][i], at.p_rod = &out->channels[3][i];
    mass.Calc(t, &at);
    if (i + 1 == force.size()) continue;
    for (int s = 0; s < options.substeps; ++s) {
      const double part = static_cast<double>(s + 1) / options.substeps;
      mass.Step(t + s * h, h, force[i] + part * (force[i + 1] - force[i]));
    }
  }
}

}  // namespace phs::rigs
