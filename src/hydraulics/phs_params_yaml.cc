// Reading model files (docs/phs_models.md).
#include "hydraulics/effects_yaml.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/phs_params_words.h"

namespace phs::hydraulics {
namespace {

const Range kPositive{.min = 0, .open_min = true};
const Range kNotNegative{.min = 0};
/// Absolute pressures at rest: what is smaller was written in MPa or bar.
const Range kPressure{.min = 1e4, .max = 1e8};

int IndexOf(const std::string& word, const std::vector<std::string>& words) {
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i] == word) return static_cast<int>(i);
  }
  return 0;
}

void ReadEndStop(YamlMap map, EndStopParams* stop) {
  stop->clearance_m = map.Number("clearance_m", kPositive, stop->clearance_m);
  stop->stiffness_N_per_m = map.Number("stiffness_N_per_m", kPositive, stop->stiffness_N_per_m);
  stop->damping_Ns_per_m = map.Number("damping_Ns_per_m", kNotNegative, stop->damping_Ns_per_m);
  stop->transition_m = map.Number("transition_m", kPositive, stop->transition_m);
}

// Keys shared by `cylinder_defaults` and each entry of `cylinders`.
void ReadCylinder(YamlMap& map, CylinderParams* c) {
  c->bore_m = map.Number("bore_m", kPositive, c->bore_m);
  c->rod_m = map.Number("rod_m", kNotNegative, c->rod_m);
  if (map.Has("end_stop")) ReadEndStop(map.Map("end_stop"), &c->end_stop);
}

void ReadGas(YamlMap& map, GasChargeParams* gas) {
  gas->law = FindGasLaw(map.Word("law", GasLawNames(), gas->law->name));
  gas->volume_m3 = map.Number("volume_m3", kNotNegative, gas->volume_m3);
  gas->polytropic_exponent =
      map.Number("polytropic_exponent", {.min = 0.9, .max = 2}, gas->polytropic_exponent);
  gas->thermal_time_s = map.Number("thermal_time_s", kPositive, gas->thermal_time_s);
  gas->min_gas_volume_m3 = map.Number("min_gas_volume_m3", kNotNegative, gas->min_gas_volume_m3);
}

// `charge_pressure_Pa`: the shell was filled with gas at this pressure and then brought to the
// static pressure by oil; slow, hence at the temperature of the surroundings.
double GasAfterCharging(const LineParams& line, double charge, double T) {
  GasVolume gas;
  // A law with a temperature of its own is isothermal once that is given.
  if (line.reservoir.law->capacity != nullptr) gas.law = line.reservoir.law;
  gas.reference_volume = line.reservoir.volume_m3;
  gas.reference_pressure = charge;
  gas.reference_temperature = T;
  gas.min_volume = 0;
  gas.max_volume = line.reservoir.volume_m3;
  gas.SetMass();
  return CalcGas(gas, line.static_pressure_Pa, T).volume;
}

// A charge given for all lines depends on each line's own static pressure, so it is kept in
// `charge` [Pa] and turned into a gas volume only by the lines themselves.
void ReadLine(YamlMap& map, LineParams* line, double* charge) {
  line->static_pressure_Pa = map.Number("static_pressure_Pa", kPressure, line->static_pressure_Pa);
  line->oil_volume_m3 = map.Number("oil_volume_m3", kPositive, line->oil_volume_m3);
  line->bulk_modulus_Pa = map.Number("bulk_modulus_Pa", kPositive, line->bulk_modulus_Pa);
  line->bulk_modulus_slope =
      map.Number("bulk_modulus_slope", {.min = 0, .max = 20}, line->bulk_modulus_slope);
  line->free_air_m3 = map.Number("free_air_m3", kNotNegative, line->free_air_m3);
  if (map.Has("reservoir")) {
    YamlMap r = map.Map("reservoir");
    ReadGas(r, &line->reservoir);
    if (r.Has("charge_pressure_Pa") && r.Has("gas_volume_m3")) {
      r.Fail("gas_volume_m3", "given together with charge_pressure_Pa", "one of the two");
    }
    if (r.Has("gas_volume_m3")) *charge = 0;
    *charge = r.Number("charge_pressure_Pa", kPressure, *charge);
    line->gas_volume_m3 = r.Number("gas_volume_m3", kNotNegative, line->gas_volume_m3);
  }
  if (map.Has("accumulator")) {
    YamlMap a = map.Map("accumulator");
    ReadGas(a, &line->accumulator);
    line->accumulator_precharge_Pa =
        a.Number("precharge_Pa", kPressure, line->accumulator_precharge_Pa);
  }
}

void ReadFriction(YamlMap map, FrictionParams* f) {
  const std::string model = map.Word("model", kModels, kModels[static_cast<int>(f->model)]);
  f->model = static_cast<FrictionModel>(IndexOf(model, kModels));
  const std::string curve = map.Word("curve", kCurves, kCurves[static_cast<int>(f->curve)]);
  f->curve = static_cast<FrictionCurve>(IndexOf(curve, kCurves));
  f->scale = map.Number("scale", kNotNegative, f->scale);
  f->speed_m_s = map.Numbers("speed_m_s", {}, f->speed_m_s);
  f->force_N = map.Numbers("force_N", {}, f->force_N);
  auto number = [&map](const char* key, const Range& range, double* value) {
    *value = map.Number(key, range, *value);
  };
  number("coulomb_extension_N", kNotNegative, &f->coulomb_extension_N);
  number("coulomb_retraction_N", kNotNegative, &f->coulomb_retraction_N);
  number("breakaway_extension_N", kNotNegative, &f->breakaway_extension_N);
  number("breakaway_retraction_N", kNotNegative, &f->breakaway_retraction_N);
  number("stribeck_speed_m_s", kPositive, &f->stribeck_speed_m_s);
  number("viscous_extension_Ns_per_m", kNotNegative, &f->viscous_extension_Ns_per_m);
  number("viscous_retraction_Ns_per_m", kNotNegative, &f->viscous_retraction_Ns_per_m);
  number("ramp_speed_m_s", kPositive, &f->ramp_speed_m_s);
  number("stiffness_N_per_m", kPositive, &f->stiffness_N_per_m);
  number("damping_Ns_per_m", kNotNegative, &f->damping_Ns_per_m);
  number("breakaway_ratio", {.min = 0, .max = 0.99}, &f->breakaway_ratio);
}

}  // namespace

std::vector<EffectParams> ReadEffects(YamlMap map) {
  std::vector<EffectParams> effects;
  for (const std::string& name : map.Keys()) {
    EffectParams effect;
    effect.name = name;
    YamlMap entry = map.Map(name);
    for (const std::string& key : entry.Keys()) {
      if (key == "targets") {
        effect.targets = entry.Texts("targets");
      } else if (key == "formula") {
        effect.formula = entry.Text("formula");
      } else {
        effect.values[key] = entry.Number(key, {});
      }
    }
    effects.push_back(std::move(effect));
  }
  return effects;
}

Result<PhsParams> ReadPhsParams(YamlMap& map) {
  PhsParams params;
  params.name = map.Text("name");
  params.description = map.Text("description", "");
  params.source = map.Text("source", "");
  params.temperature_K = map.Number("temperature_K", {.min = 200, .max = 400}, 293.15);
  const std::string balance = map.Word("balance", kBalances, kBalances[0]);
  params.balance = static_cast<BalanceMethod>(IndexOf(balance, kBalances));
  CylinderParams cylinder;
  if (map.Has("cylinder_defaults")) {
    YamlMap defaults = map.Map("cylinder_defaults");
    ReadCylinder(defaults, &cylinder);
  }
  for (YamlMap entry : map.Maps("cylinders")) {
    CylinderParams c = cylinder;
    c.name = entry.Text("name");
    c.bore_line = entry.Text("bore_line", "");
    c.rod_line = entry.Text("rod_line", "");
    ReadCylinder(entry, &c);
    params.cylinders.push_back(c);
  }
  LineParams line;
  double default_charge = 0;
  if (map.Has("line_defaults")) {
    YamlMap defaults = map.Map("line_defaults");
    ReadLine(defaults, &line, &default_charge);
  }
  for (YamlMap entry : map.Maps("lines")) {
    LineParams l = line;
    double charge = default_charge;
    l.name = entry.Text("name");
    ReadLine(entry, &l, &charge);
    if (charge > 0 && l.static_pressure_Pa > 0) {
      l.gas_volume_m3 = GasAfterCharging(l, charge, params.temperature_K);
    }
    params.lines.push_back(l);
  }
  if (map.Has("friction")) ReadFriction(map.Map("friction"), &params.friction);
  if (map.Has("element")) {
    YamlMap e = map.Map("element");
    params.element.mass_kg = e.Number("mass_kg", kNotNegative, 0);
    params.element.stiffness_N_per_m = e.Number("stiffness_N_per_m", kNotNegative, 0);
    params.element.pressure_area_m2 = e.Number("pressure_area_m2", {}, 0);
    params.element.offset_N = e.Number("offset_N", {}, 0);
  }
  if (map.Has("effects")) params.effects = ReadEffects(map.Map("effects"));
  if (Status s = map.Finish(); !s.ok()) return s.error();
  if (Status s = Validate(params); !s.ok()) {
    Error error = s.error();
    error.where = map.path() + ": " + error.where;
    return error;
  }
  return params;
}

Result<PhsParams> LoadPhsParams(const std::string& path) {
  Result<YamlMap> map = YamlMap::Load(path);
  if (!map.ok()) return map.error();
  return ReadPhsParams(map.value());
}

}  // namespace phs::hydraulics
