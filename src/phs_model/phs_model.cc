#include "phs_model/phs_model.h"

#include "base/data_path.h"
#include "base/words.h"
#include "effects/catalogue.h"

namespace phs::phs_model {

using hydraulics::EffectInfo;
using hydraulics::EffectParameter;
using hydraulics::EffectParams;
using hydraulics::PhsParams;
using hydraulics::PhsSystem;

Result<PhsParams> FindPhsParams(const std::string& name_or_path) {
  Result<std::string> path = FindData("PHS model", "models/phs", name_or_path, {".yaml"});
  if (!path.ok()) return path.error();
  return phs_model::LoadPhsParams(path.value());
}

Result<PhsSystem> LoadPhsSystem(const std::string& path) {
  Result<PhsParams> params = LoadPhsParams(path);
  if (!params.ok()) return params.error();
  return CreatePhsSystem(params.value());
}

Result<PhsSystem> CreatePhsSystem(const PhsParams& params,
                                  std::shared_ptr<const hydraulics::ExtraSeries> extra) {
  return PhsSystem::Create(params, &effects::Catalogue(), std::move(extra));
}

Status AddEffect(PhsParams* params, const std::string& effect) {
  const EffectInfo* info = effects::Catalogue().Find(effect);
  if (info == nullptr) {
    std::vector<std::string> names;
    for (const EffectInfo& known : effects::Catalogue().effects()) names.push_back(known.name);
    const std::string nearest = NearestWord(effect, names);
    return Error{effect, "no such effect", "",
                 nearest.empty() ? "" : "did you mean " + nearest + "?"};
  }
  for (const EffectParams& present : params->effects) {
    if (present.name == effect) return Error{effect, "this effect is switched on already"};
  }
  EffectParams added;
  added.name = effect;
  for (const EffectParameter& p : info->parameters) added.values[p.name] = p.otherwise;
  params->effects.push_back(std::move(added));
  return {};
}

}  // namespace phs::phs_model
