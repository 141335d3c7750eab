// Parameters by name, for fitting: "CYLINDER.key", "LINE.key", "LINE.reservoir.key",
// "LINE.accumulator.key", "friction.key", "element.key", "temperature_K", "effects.NAME.key".

#include "base/words.h"
#include "effects/catalogue.h"
#include "hydraulics/phs_numbers.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {
namespace {

using hydraulics::CylinderParams;
using hydraulics::EffectInfo;
using hydraulics::EffectParameter;
using hydraulics::EffectParams;
using hydraulics::ForEachNumber;
using hydraulics::FrictionParams;
using hydraulics::LineParams;
using hydraulics::NumberInfo;
using hydraulics::Numbers;
using hydraulics::PhsParams;

/// The number `name` of cylinders, lines, friction or element; null if there is none.
double* FindNumber(PhsParams* params, const std::string& name) {
  for (const auto& row : Numbers<PhsParams>()) {
    if (row.info.key == name) return &row.of(*params);
  }
  const auto find_in = [&name](auto& parts, const auto& rows) -> double* {
    for (auto& part : parts) {
      if (!name.starts_with(part.name + ".")) continue;
      const std::string key = name.substr(part.name.size() + 1);
      for (const auto& row : rows) {
        if (row.info.key == key) return &row.of(part);
      }
    }
    return nullptr;
  };
  if (double* value = find_in(params->cylinders, Numbers<CylinderParams>())) return value;
  return find_in(params->lines, Numbers<LineParams>());
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

Error Unknown(const PhsParams& params, const std::string& name) {
  std::vector<std::string> names;
  for (const ParameterInfo& info : ListParameters(params)) names.push_back(info.name);
  const std::string nearest = NearestWord(name, names);
  return Error{name, "no such parameter", "",
               nearest.empty() ? "see docs/phs_models.md" : "did you mean " + nearest + "?"};
}

}  // namespace

std::vector<ParameterInfo> ListParameters(const PhsParams& params) {
  PhsParams copy = params;
  std::vector<ParameterInfo> out;
  ForEachNumber(&copy, [&out](const std::string& name, const NumberInfo& info, double value) {
    out.push_back({name, info.unit, value, info.low, info.high});
  });
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
  if (const auto own = params.of_runs.find(name); own != params.of_runs.end()) return own->second;
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
  if (const double* value = FindNumber(&copy, name)) return *value;
  return Unknown(copy, name);
}

Status SetParameter(PhsParams* params, const std::string& name, double value) {
  if (const auto own = params->of_runs.find(name); own != params->of_runs.end()) {
    own->second = value;
    return {};
  }
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
  if (double* found = FindNumber(params, name)) {
    *found = value;
    return {};
  }
  return Unknown(*params, name);
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
