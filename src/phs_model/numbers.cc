// Parameters by name, for fitting: "CYLINDER.key", "LINE.key", "LINE.reservoir.key",
// "LINE.accumulator.key", "friction.key", "element.key", "temperature_K", "effects.NAME.key".
#include <cmath>
#include <functional>

#include "base/words.h"
#include "effects/catalogue.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {
namespace {

using hydraulics::CylinderParams;
using hydraulics::EffectInfo;
using hydraulics::EffectParameter;
using hydraulics::EffectParams;
using hydraulics::FrictionParams;
using hydraulics::GasChargeParams;
using hydraulics::LineParams;
using hydraulics::PhsParams;

// One addressable number: where it lives and its plausible range, as factors on the present value
// (relative) or absolute.
struct Slot {
  std::string name;
  const char* unit;
  double* value;
  double low, high;
};

void AddGasSlots(const std::string& prefix, GasChargeParams* gas, std::vector<Slot>* out) {
  out->push_back({prefix + ".volume_m3", "m3", &gas->volume_m3, 0, 5e-3});
  out->push_back({prefix + ".polytropic_exponent", "-", &gas->polytropic_exponent, 1.0, 1.6});
  out->push_back({prefix + ".thermal_time_s", "s", &gas->thermal_time_s, 0.1, 100});
  out->push_back({prefix + ".min_gas_volume_m3", "m3", &gas->min_gas_volume_m3, 0, 2e-4});
}

std::vector<Slot> CollectSlots(PhsParams* p) {
  std::vector<Slot> out;
  out.reserve(64);
  out.push_back({"temperature_K", "K", &p->temperature_K, 253, 323});
  for (CylinderParams& c : p->cylinders) {
    out.push_back({c.name + ".bore_m", "m", &c.bore_m, 0.02, 0.3});
    out.push_back({c.name + ".rod_m", "m", &c.rod_m, 0.005, 0.2});
    out.push_back({c.name + ".end_stop.clearance_m", "m", &c.end_stop.clearance_m, 0.001, 0.1});
    out.push_back(
        {c.name + ".end_stop.stiffness_N_per_m", "N/m", &c.end_stop.stiffness_N_per_m, 1e6, 1e10});
  }
  for (LineParams& l : p->lines) {
    out.push_back({l.name + ".static_pressure_Pa", "Pa", &l.static_pressure_Pa, 1e5, 5e6});
    out.push_back({l.name + ".oil_volume_m3", "m3", &l.oil_volume_m3, 2e-4, 5e-3});
    out.push_back({l.name + ".bulk_modulus_Pa", "Pa", &l.bulk_modulus_Pa, 0.5e9, 2.2e9});
    out.push_back({l.name + ".bulk_modulus_slope", "-", &l.bulk_modulus_slope, 0, 12});
    out.push_back({l.name + ".free_air_m3", "m3", &l.free_air_m3, 0, 5e-5});
    out.push_back({l.name + ".gas_volume_m3", "m3", &l.gas_volume_m3, 1e-6, 3.2e-4});
    out.push_back(
        {l.name + ".accumulator_precharge_Pa", "Pa", &l.accumulator_precharge_Pa, 5e6, 2.5e7});
    AddGasSlots(l.name + ".reservoir", &l.reservoir, &out);
    AddGasSlots(l.name + ".accumulator", &l.accumulator, &out);
  }
  FrictionParams& f = p->friction;
  out.push_back({"friction.scale", "-", &f.scale, 0.2, 3});
  out.push_back({"friction.coulomb_extension_N", "N", &f.coulomb_extension_N, 0, 6000});
  out.push_back({"friction.coulomb_retraction_N", "N", &f.coulomb_retraction_N, 0, 6000});
  out.push_back({"friction.breakaway_extension_N", "N", &f.breakaway_extension_N, 0, 9000});
  out.push_back({"friction.breakaway_retraction_N", "N", &f.breakaway_retraction_N, 0, 9000});
  out.push_back({"friction.stribeck_speed_m_s", "m/s", &f.stribeck_speed_m_s, 1e-5, 0.1});
  out.push_back(
      {"friction.viscous_extension_Ns_per_m", "N s/m", &f.viscous_extension_Ns_per_m, 0, 1e5});
  out.push_back(
      {"friction.viscous_retraction_Ns_per_m", "N s/m", &f.viscous_retraction_Ns_per_m, 0, 1e5});
  out.push_back({"friction.ramp_speed_m_s", "m/s", &f.ramp_speed_m_s, 1e-6, 0.01});
  out.push_back({"friction.stiffness_N_per_m", "N/m", &f.stiffness_N_per_m, 1e6, 1e9});
  out.push_back({"friction.damping_Ns_per_m", "N s/m", &f.damping_Ns_per_m, 0, 1e6});
  out.push_back({"friction.breakaway_ratio", "-", &f.breakaway_ratio, 0, 0.95});
  out.push_back({"element.mass_kg", "kg", &p->element.mass_kg, 0, 1e4});
  out.push_back({"element.stiffness_N_per_m", "N/m", &p->element.stiffness_N_per_m, 0, 1e9});
  out.push_back({"element.pressure_area_m2", "m2", &p->element.pressure_area_m2, -0.1, 0.1});
  out.push_back({"element.offset_N", "N", &p->element.offset_N, -1e4, 1e4});
  return out;
}

// Value of "effects.NAME.key", or null.
double* FindEffectValue(PhsParams* params, const std::string& name) {
  if (name.rfind("effects.", 0) != 0) return nullptr;
  const size_t dot = name.find('.', 8);
  if (dot == std::string::npos) return nullptr;
  for (EffectParams& effect : params->effects) {
    if (effect.name == name.substr(8, dot - 8)) return &effect.values[name.substr(dot + 1)];
  }
  return nullptr;
}

Error Unknown(const std::string& name, const std::vector<Slot>& slots) {
  std::vector<std::string> names;
  for (const Slot& slot : slots) names.push_back(slot.name);
  const std::string nearest = NearestWord(name, names);
  return Error{name, "no such parameter", "",
               nearest.empty() ? "see ListParameters" : "did you mean " + nearest + "?"};
}

}  // namespace

std::vector<ParameterInfo> ListParameters(const PhsParams& params) {
  PhsParams copy = params;
  std::vector<ParameterInfo> out;
  for (const Slot& slot : CollectSlots(&copy)) {
    out.push_back({slot.name, slot.unit, *slot.value, slot.low, slot.high});
  }
  return out;
}

/// "lines.KEY": the number KEY of every line at once, of a bogie whose lines are built alike.
constexpr char kEveryLine[] = "lines.";

static std::vector<std::string> NamesOfGroup(const PhsParams& params, const std::string& name) {
  std::vector<std::string> names;
  if (name.rfind(kEveryLine, 0) != 0) return names;
  for (const LineParams& line : params.lines) names.push_back(line.name + name.substr(5));
  return names;
}

/// "friction.coulomb_N", "friction.viscous_Ns_per_m": both directions at once. The excess of the
/// breakaway level over the Coulomb level stays.
static bool SetBothDirections(PhsParams* params, const std::string& name, double value) {
  FrictionParams& f = params->friction;
  if (name == "friction.coulomb_N") {
    f.breakaway_extension_N += value - f.coulomb_extension_N;
    f.breakaway_retraction_N += value - f.coulomb_retraction_N;
    f.coulomb_extension_N = f.coulomb_retraction_N = value;
  } else if (name == "friction.viscous_Ns_per_m") {
    f.viscous_extension_Ns_per_m = f.viscous_retraction_Ns_per_m = value;
  } else {
    return false;
  }
  return true;
}

Result<double> GetParameter(const PhsParams& params, const std::string& name) {
  PhsParams copy = params;
  if (name.rfind("effects.", 0) == 0) {
    const size_t dot = name.find('.', 8);
    for (const EffectParams& effect : copy.effects) {
      if (dot == std::string::npos || effect.name != name.substr(8, dot - 8)) continue;
      auto found = effect.values.find(name.substr(dot + 1));
      if (found != effect.values.end()) return found->second;
    }
    return Error{name, "this effect or key is not set", "", "switch the effect on first"};
  }
  if (name == "friction.coulomb_N") return copy.friction.coulomb_extension_N;
  if (name == "friction.viscous_Ns_per_m") return copy.friction.viscous_extension_Ns_per_m;
  if (const auto names = NamesOfGroup(copy, name); !names.empty()) {
    return GetParameter(params, names.front());
  }
  const std::vector<Slot> slots = CollectSlots(&copy);
  for (const Slot& slot : slots) {
    if (slot.name == name) return *slot.value;
  }
  return Unknown(name, slots);
}

Status SetParameter(PhsParams* params, const std::string& name, double value) {
  if (double* found = FindEffectValue(params, name)) {
    *found = value;
    return {};
  }
  if (name.rfind("effects.", 0) == 0) {
    return Error{name, "this effect is not switched on", "", "add it to the model's effects first"};
  }
  if (SetBothDirections(params, name, value)) return {};
  if (const auto names = NamesOfGroup(*params, name); !names.empty()) {
    for (const std::string& one : names) {
      if (Status s = SetParameter(params, one, value); !s.ok()) return s;
    }
    return {};
  }
  const std::vector<Slot> slots = CollectSlots(params);
  for (const Slot& slot : slots) {
    if (slot.name != name) continue;
    *slot.value = value;
    return {};
  }
  return Unknown(name, slots);
}

std::vector<ParameterInfo> ListAllParameters(const PhsParams& params) {
  std::vector<ParameterInfo> out = phs_model::ListParameters(params);
  for (const EffectParams& effect : params.effects) {
    const EffectInfo* info = effects::Catalogue().Find(effect.name);
    if (info == nullptr) continue;
    for (const EffectParameter& p : info->parameters) {
      auto found = effect.values.find(p.name);
      const double value = found == effect.values.end() ? p.otherwise : found->second;
      out.push_back({"effects." + effect.name + "." + p.name, p.unit, value, p.low, p.high});
    }
  }
  return out;
}

}  // namespace phs::phs_model
