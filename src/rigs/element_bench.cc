#include "rigs/element_bench.h"

#include <algorithm>
#include <cmath>

namespace phs::rigs {
namespace {

using hydraulics::Friction;
using hydraulics::FrictionModel;
using hydraulics::FrictionPlace;
using hydraulics::Mount;

/// Friction at the end of a gap and a spring.
class MountedFriction {
 public:
  MountedFriction(const Friction& friction, const Mount& mount, double x, double h)
      : friction_(friction),
        mount_(mount),
        y_(x),
        h_(h),
        memory_(static_cast<size_t>(friction.num_memories()), 0.0) {}
  /// Force with the drive at x, v now; `place` without piston and memory.
  double Calc(double x, double v, FrictionPlace place) {
    place.memory = memory_.data();
    if (!mount_.present()) {
      place.piston = y_ = x;
      direction_ = friction_.Direction(v, z_, place);
      return friction_.Calc(v, z_, place).force;
    }
    const double move = SolveMove(x, place);
    Advance(h_, move / h_, place);
    y_ += move;
    direction_ = friction_.Direction(move / h_, z_, place);
    return MountForce(x - y_);
  }
  /// To the next sample, the drive at mean speed v (without a mount only: else done in Calc).
  void Move(double v, FrictionPlace place) {
    if (mount_.present()) return;
    place.piston = y_;
    place.memory = memory_.data();
    Advance(h_, v, place);
  }
  double direction() const { return direction_; }

 private:
  /// Move of y that balances friction and mount. Their difference rises with the move: false
  /// position with the Illinois rule inside a bracket.
  double SolveMove(double x, const FrictionPlace& place) const {
    const double reach = std::abs(x - y_) + mount_.play() + 1e-12;
    const auto excess = [&](double move) {
      return FrictionAfter(move, place) - MountForce(x - y_ - move);
    };
    double low = -reach, high = reach, at_low = excess(low), at_high = excess(high);
    if (at_low >= 0) return low;
    if (at_high <= 0) return high;
    for (int i = 0, side = 0; i < 40 && high - low > 1e-9 * reach; ++i) {
      double middle = (low * at_high - high * at_low) / (at_high - at_low);
      if (i % 8 == 7) middle = 0.5 * (low + high);
      const double now = excess(middle);
      if (now > 0) {
        high = middle, at_high = now;
        if (side == 1) at_low *= 0.5;
        side = 1;
      } else if (now < 0) {
        low = middle, at_low = now;
        if (side == -1) at_high *= 0.5;
        side = -1;
      } else {
        return middle;
      }
    }
    return 0.5 * (low + high);
  }
  double MountForce(double u) const {
    double slope;
    return mount_.SpringForce(mount_.PlayFree(u), &slope);
  }
  double FrictionAfter(double move, FrictionPlace place) const {
    place.piston = y_ + move;
    double z = z_;
    if (friction_.model() == FrictionModel::kPresliding) {
      z = friction_.Advance(h_, move / h_, z_, place);
    }
    return friction_.Calc(move / h_, z, place).force;
  }
  void Advance(double h, double v, const FrictionPlace& place) {
    if (friction_.model() == FrictionModel::kPresliding) z_ = friction_.Advance(h, v, z_, place);
    if (memory_.empty()) return;
    FrictionPlace middle = place;
    middle.piston = y_ + 0.5 * h * v;
    friction_.AdvanceMemories(h, v, z_, middle, memory_.data());
  }

  const Friction& friction_;
  const Mount& mount_;
  double y_, h_;
  std::vector<double> memory_;
  double z_ = 0, direction_ = 0;
};

}  // namespace

double GasSpringForce(const hydraulics::ElementParams& part, double x) {
  constexpr double kLeast = 0.01;  // of the length
  if (part.gas_force_N == 0) return 0;
  const double left = std::max(kLeast, 1 - x / part.gas_length_m);
  const double force = part.gas_force_N * (std::pow(left, -part.gas_exponent) - 1);
  return part.gas_length_m > 0 ? force : -force;
}

void RunElementBench(const hydraulics::PhsSystem& system, const RigMotion& motion,
                     const std::vector<double>& speed, std::vector<double>* force,
                     ElementPlaces* places) {
  const int n = motion.num_samples();
  const hydraulics::ElementParams& part = system.params().element;
  const std::vector<double>& x = motion.position_m[0];
  std::vector<double> acceleration;
  if (part.mass_kg > 0 || !system.loads().empty()) {
    acceleration = AccelerationOf(motion, speed);
  }
  MountedFriction friction(system.friction(0), system.mount(0), x[0], motion.step_s);
  if (places != nullptr) places->direction.resize(static_cast<size_t>(n));
  double extra[hydraulics::kMaxExtra];
  for (int i = 0; i < n; ++i) {
    FrictionPlace place;
    if (system.extra() != nullptr) {
      system.extra()->At(motion.t0_s + i * motion.step_s, extra);
      place.extra = extra;
    }
    place.time = motion.t0_s + i * motion.step_s;
    const double p = motion.pressure_Pa.empty() ? 0 : motion.pressure_Pa[i];
    place.bore_rise = p;
    const double T =
        motion.temperature_K.empty() ? system.Ambient(place.time) : motion.temperature_K[i];
    place.warmer = T - system.params().temperature_K;
    double sum = part.offset_N + part.stiffness_N_per_m * x[i] + part.pressure_area_m2 * p +
                 friction.Calc(x[i], speed[i], place);
    sum += part.hardening_N_per_m3 * x[i] * x[i] * x[i] + GasSpringForce(part, x[i]) +
           part.quadratic_damping_Ns2_per_m2 * speed[i] * std::abs(speed[i]);
    if (part.mass_kg > 0) sum += part.mass_kg * acceleration[i];
    (*force)[i] = sum;
    if (places != nullptr) places->direction[i] = friction.direction();
    if (i + 1 == n) continue;
    friction.Move((x[i + 1] - x[i]) / motion.step_s, place);
  }
  for (const auto& law : system.loads()) {
    law->Add(
        {motion.step_s, acceleration, motion.pressure_Pa, x, speed, motion.t0_s, system.extra()},
        force);
  }
}

}  // namespace phs::rigs
