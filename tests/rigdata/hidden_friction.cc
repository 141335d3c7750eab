// Friction effects of the list.
#include "hidden_effect.h"

namespace rigdata {
namespace {

HiddenEffect Stribeck(RandomSource& random) {
  constexpr StribeckForm kForms[] = {StribeckForm::kGaussian, StribeckForm::kExponential,
                                     StribeckForm::kLorentz};
  constexpr const char* kNames[] = {"gaussian", "exponential", "lorentz"};
  const int form = random.Integer(3);
  const double speed = random.LogUniform(0.8e-3, 4e-3);
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.largest = 3;
  effect.strong_low = 3;
  effect.strong_high = 8;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    FrictionParams& f = r->rig.friction;
    f.stribeck = kForms[form];
    f.stribeck_force = 400 * size;
    f.stribeck_speed = speed;
    return {{"force_N", f.stribeck_force}, {"speed_m_s", speed}};
  };
  return effect;
}

HiddenEffect Presliding(RandomSource& random) {
  constexpr PreslidingForm kForms[] = {PreslidingForm::kLuGre, PreslidingForm::kMaxwellSlip,
                                       PreslidingForm::kDahl};
  constexpr const char* kNames[] = {"lugre", "maxwell_slip", "dahl"};
  const int form = random.Integer(3);
  const double distance = random.LogUniform(12e-6, 150e-6);
  const double damping = random.Uniform(0.3e-3, 2e-3);
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.largest = 1;
  effect.strong_low = 10;
  effect.strong_high = 60;  // the whole base sticks, whatever that makes against the noise
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    FrictionParams& f = r->rig.friction;
    f.presliding = kForms[form];
    f.presliding_share = size;
    f.presliding_distance = distance;
    f.presliding_damping = damping * f.scale * 1700.0 / distance;
    return {{"share", size}, {"distance_m", distance}, {"damping_N_s_m", f.presliding_damping}};
  };
  return effect;
}

HiddenEffect PressureFriction(RandomSource& random) {
  constexpr PressureFrictionForm kForms[] = {PressureFrictionForm::kSum,
                                             PressureFrictionForm::kDifference,
                                             PressureFrictionForm::kRodSeal};
  constexpr const char* kNames[] = {"mean_pressure", "pressure_difference", "rod_seal"};
  const int form = random.Integer(3);
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.largest = 4;
  effect.strong_low = 3;
  effect.strong_high = 10;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->rig.friction.pressure = kForms[form];
    r->rig.friction.pressure_area = 3e-5 * size;
    return {{"area_m2", 3e-5 * size}};
  };
  return effect;
}

HiddenEffect PositionFriction(RandomSource& random) {
  constexpr PositionFrictionForm kForms[] = {
      PositionFrictionForm::kLinear, PositionFrictionForm::kTightSpot, PositionFrictionForm::kWave};
  constexpr const char* kNames[] = {"linear", "tight_spot", "wave"};
  const int form = random.Integer(3);
  const double centre = random.Uniform(-1.2e-3, 1.8e-3);
  const double length = form == 0 ? 3e-3 * random.Sign() : random.Uniform(0.8e-3, 2.5e-3);
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.largest = 2;
  effect.strong_low = 3;
  effect.strong_high = 10;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    FrictionParams& f = r->rig.friction;
    f.position = kForms[form];
    f.position_share = 0.3 * size;
    f.position_centre = centre;
    f.position_length = length;
    return {{"share", f.position_share}, {"centre_m", centre}, {"length_m", length}};
  };
  return effect;
}

HiddenEffect DwellFriction(RandomSource& random) {
  const bool saturating = random.Coin();
  const double time = saturating ? random.Uniform(0.5, 3.0) : random.Uniform(0.2, 1.0);
  const double distance = random.LogUniform(100e-6, 600e-6);
  HiddenEffect effect;
  effect.form = saturating ? "saturating" : "ageing";
  effect.largest = 5;
  effect.strong_low = 2;
  effect.strong_high = 5;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    FrictionParams& f = r->rig.friction;
    f.dwell = saturating ? DwellForm::kSaturating : DwellForm::kAgeing;
    f.dwell_force = (saturating ? 500 : 250) * size;
    f.dwell_time = time;
    f.dwell_distance = distance;
    return {{"force_N", f.dwell_force}, {"time_s", time}, {"distance_m", distance}};
  };
  return effect;
}

HiddenEffect ViscousFriction(RandomSource& random) {
  constexpr ViscousForm kForms[] = {ViscousForm::kLinear, ViscousForm::kRoot, ViscousForm::kSquare};
  constexpr const char* kNames[] = {"linear", "power_0.7", "square"};
  const int form = random.Integer(3);
  HiddenEffect effect;
  effect.form = kNames[form];
  effect.largest = 8;
  effect.strong_low = 3;
  effect.strong_high = 10;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->rig.friction.viscous = kForms[form];
    r->rig.friction.viscous_force = 250 * size;
    return {{"force_at_20_mm_s_N", 250 * size}};
  };
  return effect;
}

HiddenEffect Asymmetry(RandomSource& random) {
  const double sign = random.Sign();
  HiddenEffect effect;
  effect.form = sign > 0 ? "more_in_extension" : "more_in_retraction";
  effect.largest = 4;
  effect.strong_low = 3;
  effect.strong_high = 10;
  effect.apply = [=](double size, TrueRig* r) -> NumberList {
    r->rig.friction.asymmetry = 0.1 * sign * size;
    return {{"share", r->rig.friction.asymmetry}};
  };
  return effect;
}

}  // namespace

HiddenEffect DrawFriction(const std::string& name, RandomSource& random) {
  if (name == "stribeck") return Stribeck(random);
  if (name == "presliding") return Presliding(random);
  if (name == "pressure_friction") return PressureFriction(random);
  if (name == "position_friction") return PositionFriction(random);
  if (name == "dwell_friction") return DwellFriction(random);
  if (name == "viscous_friction") return ViscousFriction(random);
  if (name == "asymmetric_friction") return Asymmetry(random);
  return {};
}

}  // namespace rigdata
