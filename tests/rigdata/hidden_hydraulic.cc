// Hydraulic effects and the warming of the rig.
#include <array>
#include <cmath>

#include "hidden_effect.h"

namespace rigdata {
namespace {

struct LeakChoice {
  LeakForm form;
  const char* name;
  double conductance;  // at size 1: about the same flow at 5 MPa
};

LeakChoice DrawLeak(RandomSource& random, double flow_at_5MPa) {
  switch (random.Integer(3)) {
    case 0:
      return {LeakForm::kLaminar, "laminar", flow_at_5MPa / 5e6};
    case 1:
      return {LeakForm::kOrifice, "orifice", flow_at_5MPa / std::sqrt(5e6)};
    default:
      return {LeakForm::kWidening, "widening_gap", flow_at_5MPa / 7.5e6};
  }
}

HiddenEffect PistonLeakage(RandomSource& random) {
  const LeakChoice leak = DrawLeak(random, 1e-7);
  HiddenEffect effect;
  effect.form = leak.name;
  effect.smallest = 0.003;
  effect.apply = [leak](double size, TrueRig* r) -> NumberList {
    r->rig.piston_leak = {leak.form, leak.conductance * size};
    return {{"conductance", leak.conductance * size}};
  };
  return effect;
}

HiddenEffect ExternalLeakage(RandomSource& random) {
  const LeakChoice leak = DrawLeak(random, 8e-9);
  const int where = random.Integer(3);
  HiddenEffect effect;
  effect.form = std::string(leak.name) + (where == 0 ? "_bore" : where == 1 ? "_rod" : "_both");
  effect.smallest = 0.003;
  effect.apply = [leak, where](double size, TrueRig* r) -> NumberList {
    const LeakPath path{leak.form, leak.conductance * size};
    if (where != 1) r->rig.bore.leak = path;
    if (where != 0) r->rig.rod.leak = path;
    return {{"conductance", path.conductance}};
  };
  return effect;
}

// Restrictions between chamber and reservoir; `back` is the resistance of the other direction.
HiddenEffect Restriction(RandomSource& random, bool one_way) {
  const int form = random.Integer(one_way ? 2 : 3);  // laminar, turbulent, both
  const double other = random.Uniform(0.7, 1.4);     // rod line against bore line
  const int stiff = random.Integer(2);               // resisting direction
  const double back = one_way ? random.Uniform(0.02, 0.08) : 1.0;
  const double share = random.Uniform(0.15, 0.3);
  HiddenEffect effect;
  constexpr const char* kForm[] = {"laminar", "turbulent", "laminar_and_turbulent"};
  effect.form = kForm[form];
  if (one_way) effect.form += stiff == 0 ? "_outflow" : "_inflow";
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    const double laminar = form == 1 ? 0 : 3e8 * size;
    const double turbulent = form == 0 ? 0 : 1.5e12 * size;
    double scale = 1;
    for (LineParams* line : {&r->rig.bore, &r->rig.rod}) {
      line->chamber_share = share;
      line->laminar[stiff] = scale * laminar;
      line->turbulent[stiff] = scale * turbulent;
      line->laminar[1 - stiff] = back * scale * laminar;
      line->turbulent[1 - stiff] = back * scale * turbulent;
      scale = other;
    }
    return {{"laminar_Pa_s_m3", laminar},
            {"turbulent_Pa_s2_m6", turbulent},
            {"rod_over_bore", other},
            {"other_direction_share", back}};
  };
  return effect;
}

HiddenEffect Inertance(RandomSource& random) {
  const double ratio = random.Uniform(0.7, 1.4), damping = random.Uniform(0.003, 0.006);
  HiddenEffect effect;
  effect.form = "column";
  effect.calibration_step = 2e-4;  // the column rings
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    const double inertance = 1.5e7 * size;
    double scale = 1;
    for (LineParams* line : {&r->rig.bore, &r->rig.rod}) {
      line->chamber_share = 0.15;
      line->inertance = scale * inertance;
      const double chamber = line->oil_compliance * line->chamber_share;
      const double friction = 2.0 * damping * std::sqrt(line->inertance / chamber);
      line->laminar = {friction, friction};
      scale = ratio;
    }
    return {{"inertance_kg_m4", inertance}, {"rod_over_bore", ratio}, {"damping_ratio", damping}};
  };
  return effect;
}

HiddenEffect EntrainedAir(RandomSource& random) {
  const int form = random.Integer(3);
  const double saturation = random.Uniform(5e6, 12e6), exponent = random.Uniform(1.1, 1.4);
  const double lag = random.Uniform(0.3, 3.0), ratio = random.Uniform(0.6, 1.6);
  HiddenEffect effect;
  constexpr const char* kForm[] = {"dissolving", "polytropic_dissolving", "lagging_dissolution"};
  effect.form = kForm[form];
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    constexpr AirForm kForms[] = {AirForm::kDissolving, AirForm::kPolytropicDissolving,
                                  AirForm::kLaggingDissolution};
    double volume = 2e-6 * size;
    for (LineParams* line : {&r->rig.bore, &r->rig.rod}) {
      line->air_form = kForms[form];
      line->air_volume = volume;
      line->air_saturation = saturation;
      line->air_exponent = exponent;
      line->air_lag = lag;
      volume *= ratio;
    }
    return {{"volume_bore_m3", 2e-6 * size},
            {"rod_over_bore", ratio},
            {"saturation_Pa", saturation},
            {"exponent", exponent},
            {"lag_s", lag}};
  };
  return effect;
}

HiddenEffect HoseExpansion(RandomSource& random) {
  const bool viscoelastic = random.Coin();
  const double scale = random.Uniform(2.5e6, 7e6), tau = random.LogUniform(0.3, 6.0);
  const double ratio = random.Uniform(0.7, 1.4);
  HiddenEffect effect;
  effect.form = viscoelastic ? "viscoelastic" : "stiffening";
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    double volume = 2e-6 * size;
    for (LineParams* line : {&r->rig.bore, &r->rig.rod}) {
      line->hose_form = viscoelastic ? HoseForm::kViscoelastic : HoseForm::kStiffening;
      line->hose_volume = volume;
      line->hose_scale = scale;
      line->hose_tau = tau;
      volume *= ratio;
    }
    return {{"volume_bore_m3", 2e-6 * size},
            {"rod_over_bore", ratio},
            {"scale_Pa", scale},
            {"tau_s", tau}};
  };
  return effect;
}

HiddenEffect GasThermal(RandomSource& random) {
  const double ratio = random.Uniform(0.8, 1.25);
  const double wall = random.Coin() ? 0 : random.Uniform(20, 70);
  const double tau = random.LogUniform(0.4, 12.0);
  constexpr double kNitrogen = 296.8 / 743.0;
  HiddenEffect effect;
  effect.form = wall > 0 ? "gas_and_wall" : "gas_to_constant_wall";
  effect.smallest = 0.005;
  effect.largest = 1;
  effect.strong_low = 40;  // plain nitrogen in most cases; with a heat-storing filler in the rest
  effect.strong_high = 400;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->rig.bore.gas_tau = tau;
    r->rig.rod.gas_tau = ratio * tau;
    r->rig.bore.gas_coupling = r->rig.rod.gas_coupling = kNitrogen * size;
    r->rig.bore.wall_tau = r->rig.rod.wall_tau = wall;
    return {{"tau_bore_s", tau},
            {"tau_rod_s", ratio * tau},
            {"R_over_cv", kNitrogen * size},
            {"wall_tau_s", wall}};
  };
  return effect;
}

HiddenEffect Precharge(RandomSource& random) {
  const double sign = random.Uniform() < 0.7 ? -1 : 1;
  HiddenEffect effect;
  effect.form = sign < 0 ? "lower" : "higher";
  effect.strong_low = 8;
  effect.strong_high = 60;
  effect.smallest = 0.02;
  effect.largest = sign < 0 ? 2.6 : 1.5;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->rig.rod.blow_off_precharge = 15e6 + sign * 1.2e6 * size;
    return {{"precharge_Pa", r->rig.rod.blow_off_precharge}};
  };
  return effect;
}

HiddenEffect DiaphragmStop(RandomSource& random) {
  const int where = random.Integer(3);
  const double softness = random.LogUniform(0.01, 0.2);
  HiddenEffect effect;
  effect.form = where == 0 ? "bore" : where == 1 ? "rod" : "both";
  effect.smallest = 0.05;
  effect.largest = 1.3;
  effect.strong_high = 60;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    // Size 1: the gas cannot go below a quarter of its static volume (about 8 MPa).
    for (LineParams* line : {&r->rig.bore, &r->rig.rod}) {
      if ((line == &r->rig.bore) == (where == 1) && where != 2) continue;
      line->gas_stop = 0.25 * size * line->gas_volume0;
      line->gas_stop_softness = softness;
    }
    return {{"stop_share_of_static_volume", 0.25 * size}, {"softness", softness}};
  };
  return effect;
}

HiddenEffect Cavitation(RandomSource& random) {
  const bool plateau = random.Coin();
  const double pressure = random.Uniform(0.45e6, 0.8e6);
  HiddenEffect effect;
  effect.form = plateau ? "plateau" : "release";
  effect.wants_deep = true;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    for (LineParams* line : {&r->rig.bore, &r->rig.rod}) {
      line->vapour_form = plateau ? VapourForm::kPlateau : VapourForm::kRelease;
      line->vapour_pressure = pressure;
      line->vapour_volume = 5e-6 * size;
    }
    return {{"pressure_Pa", pressure}, {"volume_m3", 5e-6 * size}};
  };
  return effect;
}

HiddenEffect Warming(RandomSource& random) {
  constexpr WarmingForm kForms[] = {WarmingForm::kRamp, WarmingForm::kSettling, WarmingForm::kWave};
  constexpr const char* kNames[] = {"ramp", "settling", "wave"};
  const int form = random.Integer(3);
  const double tau = random.Uniform(25, 80), gas = random.Uniform(0.3, 1.0);
  const double sign = random.Uniform() < 0.8 ? 1 : -1;
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.smallest = 0.01;
  effect.strong_high = 40;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->rig.environment = {kForms[form], sign * size, tau, gas};
    return {{"warming_K", sign * size}, {"tau_s", tau}, {"gas_share", gas}};
  };
  return effect;
}

}  // namespace

HiddenEffect DrawHydraulic(const std::string& name, RandomSource& random) {
  if (name == "piston_leakage") return PistonLeakage(random);
  if (name == "external_leakage") return ExternalLeakage(random);
  if (name == "line_resistance") return Restriction(random, false);
  if (name == "check_restriction") return Restriction(random, true);
  if (name == "line_inertance") return Inertance(random);
  if (name == "entrained_air") return EntrainedAir(random);
  if (name == "hose_expansion") return HoseExpansion(random);
  if (name == "gas_thermal") return GasThermal(random);
  if (name == "accumulator_precharge") return Precharge(random);
  if (name == "diaphragm_stop") return DiaphragmStop(random);
  if (name == "cavitation") return Cavitation(random);
  if (name == "temperature_drift") return Warming(random);
  return {};
}

}  // namespace rigdata
