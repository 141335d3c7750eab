// Finding an effect in the catalogue and filling in what a model left to its defaults.
#include <cmath>

#include "base/range.h"
#include "base/words.h"
#include "hydraulics/compiled_phs.h"

namespace phs::hydraulics {

const EffectInfo* EffectTable::Find(const std::string& name) const {
  for (const EffectInfo& info : effects()) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

const EffectInfo* EffectTable::FindFor(const EffectParams& effect) const {
  const EffectInfo* listed = Find(effect.name);
  return listed == nullptr && !effect.formula.empty() ? own() : listed;
}

namespace {

Status CheckTargets(const PhsParams& params, const EffectParams& effect, const EffectInfo& info) {
  for (const std::string& target : effect.targets) {
    const bool known =
        (info.targets.starts_with("cylinders") && params.FindCylinder(target) >= 0) ||
        (info.targets.ends_with("lines") && params.FindLine(target) >= 0);
    if (known) continue;
    return Error{"effects." + effect.name + ".targets",
                 "\"" + target + "\" is none of the model's " +
                     (info.targets.empty() ? "targets: this effect has none" : info.targets),
                 ""};
  }
  return {};
}

}  // namespace

Result<EffectParams> CompleteEffect(const PhsParams& params, const EffectParams& effect,
                                    const EffectTable& table) {
  const std::string where = "effects." + effect.name;
  const EffectInfo* info = table.FindFor(effect);
  if (info == nullptr) {
    std::vector<std::string> names;
    for (const EffectInfo& known : table.effects()) names.push_back(known.name);
    const std::string nearest = NearestWord(effect.name, names);
    std::string all;
    for (const std::string& n : names) all += (all.empty() ? "" : ", ") + n;
    return Error{where, "no such effect", all,
                 nearest.empty() ? "" : "did you mean " + nearest + "?"};
  }
  if (info == table.own()) {  // its numbers are what its formula names: checked there
    if (Status s = CheckTargets(params, effect, *info); !s.ok()) return s.error();
    return effect;
  }
  EffectParams full = effect;
  full.values.clear();
  for (const EffectParameter& p : info->parameters) full.values[p.name] = p.otherwise;
  for (const auto& [key, value] : effect.values) {
    auto found = full.values.find(key);
    if (found == full.values.end()) {
      std::vector<std::string> names;
      for (const EffectParameter& p : info->parameters) names.push_back(p.name);
      const std::string nearest = NearestWord(key, names);
      return Error{where + "." + key, "unknown key", JoinWords(names),
                   nearest.empty() ? "" : "did you mean " + nearest + "?"};
    }
    found->second = value;
  }
  if (effect.formula.empty() == info->has_formula) {
    return Error{where, info->has_formula ? "has no formula" : "takes no formula",
                 info->has_formula ? "formula: \"c1*s*…\"" : "parameters only", ""};
  }
  for (const EffectParameter& p : info->parameters) {
    const double value = full.values[p.name];
    if (std::isfinite(value) && value >= p.min && value <= p.max) continue;
    return Error{where + "." + p.name, std::to_string(value) + " is out of range",
                 Range{.min = p.min, .max = p.max}.Text()};
  }
  if (Status s = CheckTargets(params, full, *info); !s.ok()) return s.error();
  return full;
}

}  // namespace phs::hydraulics
