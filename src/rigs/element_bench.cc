#include "rigs/element_bench.h"

#include <algorithm>
#include <cmath>

#include "rigs/mounted_friction.h"

namespace phs::rigs {

using hydraulics::FrictionPlace;

double GasSpringForce(const hydraulics::ElementParams& part, double x) {
  constexpr double kLeast = 0.01;  // of the length
  if (part.gas_force_N == 0) return 0;
  const double left = std::max(kLeast, 1 - x / part.gas_length_m);
  const double force = part.gas_force_N * (std::pow(left, -part.gas_exponent) - 1);
  return part.gas_length_m > 0 ? force : -force;
}

FrictionPlace ElementPlace(const hydraulics::PhsSystem& system, const RigMotion& motion, double at,
                           double* extra) {
  const auto value = [at](const std::vector<double>& row) {
    const auto i = std::min(static_cast<size_t>(at), row.size() - 1);
    const double part = at - static_cast<double>(i);
    return part > 0 && i + 1 < row.size() ? row[i] + part * (row[i + 1] - row[i]) : row[i];
  };
  FrictionPlace place;
  place.time = motion.t0_s + at * motion.step_s;
  if (system.extra() != nullptr) {
    system.extra()->At(place.time, extra);
    place.extra = extra;
  }
  place.bore_rise = motion.pressure_Pa.empty() ? 0 : value(motion.pressure_Pa);
  const double T =
      motion.temperature_K.empty() ? system.Ambient(place.time) : value(motion.temperature_K);
  place.warmer = T - system.params().temperature_K;
  return place;
}

double ElementForce(const hydraulics::ElementParams& part, double x, double v, double pressure) {
  return part.offset_N + part.stiffness_N_per_m * x + part.hardening_N_per_m3 * x * x * x +
         part.pressure_area_m2 * pressure + GasSpringForce(part, x) +
         (part.damping_Ns_per_m + part.quadratic_damping_Ns2_per_m2 * std::abs(v)) * v;
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
    const FrictionPlace place = ElementPlace(system, motion, i, extra);
    double sum =
        ElementForce(part, x[i], speed[i], place.bore_rise) + friction.Calc(x[i], speed[i], place);
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
