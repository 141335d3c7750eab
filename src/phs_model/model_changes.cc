#include "phs_model/model_changes.h"

#include "phs_model/bogie_spread.h"

namespace phs::phs_model {

using hydraulics::EffectParams;
using hydraulics::PhsParams;

void ReadParameters(YamlMap map, PhsChanges* changes) {
  for (const std::string& name : map.Keys()) {
    changes->parameters[name] = map.Number(name, {});
    changes->places[name] = map.Where(name);
  }
}

Status ApplyChanges(const PhsChanges& changes, const std::string& system, PhsParams* params) {
  for (const EffectParams& effect : changes.effects) {
    for (const EffectParams& present : params->effects) {
      if (present.name != effect.name) continue;
      return Error{"effects: " + effect.name, "is in PHS model " + params->name + " already",
                   "each effect once", "phs_parameters: {effects." + effect.name + ".KEY: …}"};
    }
    params->effects.push_back(effect);
  }
  for (const auto& [name, value] : changes.parameters) {
    if (Status s = SetParameter(params, name, value); !s.ok()) {
      Error e = s.error();
      if (const auto at = changes.places.find(name); at != changes.places.end())
        e.where = at->second;
      return e;
    }
  }
  return ApplyFailures(changes.failures, system, params);
}

Result<PhsParams> LoadChangedParams(const std::string& path, const PhsChanges& changes,
                                    const std::string& system, int actuators) {
  auto params = LoadPhsParams(path);
  if (!params.ok()) return params.error();
  if (actuators >= 4 && IsQuarter(params.value())) params = SpreadOverBogie(params.value());
  if (Status s = ApplyChanges(changes, system, &params.value()); !s.ok()) return s.error();
  return params;
}

Result<hydraulics::PhsSystem> LoadPhsSystem(const std::string& path, const PhsChanges& changes,
                                            const std::string& system, int actuators) {
  auto params = LoadChangedParams(path, changes, system, actuators);
  if (!params.ok()) return params.error();
  return CreatePhsSystem(params.value());
}

}  // namespace phs::phs_model
