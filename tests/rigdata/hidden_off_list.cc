// Effects that no list of the product holds.
#include "hidden_effect.h"

namespace rigdata {
namespace {

using Apply = std::function<NumberList(double, TrueRig*)>;

HiddenEffect Make(const char* form, double largest, Apply apply) {
  HiddenEffect effect;
  effect.form = form;
  effect.listed = false;
  effect.largest = largest;
  effect.apply = std::move(apply);
  return effect;
}

HiddenEffect DrawForceEffect(const std::string& name, RandomSource& random) {
  if (name == "piston_area_error") {
    const bool rod = random.Coin();
    const double sign = random.Sign();
    return Make(rod ? "rod_side" : "bore_side", 8, [=](double size, TrueRig* r) -> NumberList {
      const double error = 0.01 * sign * size;
      (rod ? r->rig.rod_area_error : r->rig.bore_area_error) = error;
      return {{"relative_error", error}};
    });
  }
  if (name == "actuator_ripple") {
    const double frequency = random.Uniform(6, 40), phase = random.Uniform(0, 6.283);
    return Make("in_time", 10, [=](double size, TrueRig* r) -> NumberList {
      r->rig.ripple = {100 * size, 0, frequency, phase};
      return {{"amplitude_N", 100 * size}, {"frequency_Hz", frequency}};
    });
  }
  if (name == "cogging_force") {
    const double wavelength = random.Uniform(0.5e-3, 3e-3), phase = random.Uniform(0, 6.283);
    return Make("in_position", 10, [=](double size, TrueRig* r) -> NumberList {
      r->rig.ripple = {100 * size, wavelength, 0, phase};
      return {{"amplitude_N", 100 * size}, {"wavelength_m", wavelength}};
    });
  }
  return {};
}

HiddenEffect DrawFrictionEffect(const std::string& name, RandomSource& random) {
  if (name == "friction_heating") {
    const double tau = random.Uniform(30, 120);
    return Make("falls_with_heat", 4, [=](double size, TrueRig* r) -> NumberList {
      r->rig.friction.heating_share = 0.05 * size;
      r->rig.friction.heating_tau = tau;
      return {{"share_per_100_J", 0.05 * size}, {"tau_s", tau}};
    });
  }
  if (name == "seal_swelling") {
    const double tau = random.Uniform(40, 150);
    return Make("grows_with_time", 8, [=](double size, TrueRig* r) -> NumberList {
      r->rig.friction.swelling_share = 0.15 * size;
      r->rig.friction.swelling_tau = tau;
      return {{"share", 0.15 * size}, {"tau_s", tau}};
    });
  }
  if (name == "acceleration_friction") {
    return Make("rises_with_acceleration", 6, [=](double size, TrueRig* r) -> NumberList {
      r->rig.friction.acceleration_share = 0.08 * size;
      return {{"share", 0.08 * size}};
    });
  }
  return {};
}

HiddenEffect DrawLineOrSensorEffect(const std::string& name, RandomSource& random) {
  if (name == "relief_valve") {
    const double pressure = random.Uniform(6e6, 11e6);
    return Make("bore_line", 20, [=](double size, TrueRig* r) -> NumberList {
      r->rig.bore.relief_pressure = pressure;
      r->rig.bore.relief_conductance = 2e-14 * size;
      return {{"pressure_Pa", pressure}, {"conductance_m3_s_Pa", 2e-14 * size}};
    });
  }
  if (name == "oil_stiffening") {
    return Make("bulk_modulus_with_pressure", 20, [=](double size, TrueRig* r) -> NumberList {
      r->rig.bore.oil_stiffening = r->rig.rod.oil_stiffening = 7e-9 * size;
      return {{"per_Pa", 7e-9 * size}};
    });
  }
  if (name == "pressure_crosstalk") {
    const double back = random.Uniform(0, 1), sign = random.Sign();
    return Make("between_pressures", 20, [=](double size, TrueRig* r) -> NumberList {
      r->sensors[kPBore].crosstalk = 0.005 * sign * size;
      r->sensors[kPRod].crosstalk = 0.005 * sign * size * back;
      return {{"into_bore", 0.005 * sign * size}, {"into_rod", 0.005 * sign * size * back}};
    });
  }
  if (name == "load_cell_hysteresis") {
    const double span = random.LogUniform(5e3, 4e4);
    return Make("play", 20, [=](double size, TrueRig* r) -> NumberList {
      r->sensors[kLoad].hysteresis = 100 * size;
      r->sensors[kLoad].hysteresis_span = span;
      return {{"half_width_N", 100 * size}, {"span_N", span}};
    });
  }
  if (name == "load_cell_curvature") {
    const double sign = random.Sign();
    return Make("quadratic", 20, [=](double size, TrueRig* r) -> NumberList {
      r->sensors[kLoad].curvature = 0.005 * sign * size;
      return {{"error_at_100_kN", 0.005 * sign * size}};
    });
  }
  return {};
}

}  // namespace

HiddenEffect DrawOffList(const std::string& name, RandomSource& random) {
  for (const auto draw : {DrawForceEffect, DrawFrictionEffect, DrawLineOrSensorEffect}) {
    HiddenEffect effect = draw(name, random);
    if (effect.apply) return effect;
  }
  return {};
}

}  // namespace rigdata
