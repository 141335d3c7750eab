#include "effects/unlisted.h"

#include <memory>

#include "effects/force_formula.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;

Status Install(const EffectParams& effect, Extension* extension) {
  std::map<std::string, double> coefficients;
  for (int k = 1; k <= 6; ++k) {
    std::string name = std::to_string(k);
    name.insert(name.begin(), 'c');
    coefficients[name] = effect.values.at(name + "_N");
  }
  Result<ForceFormula> formula = ForceFormula::Parse(effect.formula, coefficients);
  if (!formula.ok()) {
    Error error = formula.error();
    error.where = "effects." + effect.name + "." + error.where;
    return error;
  }
  const auto law = std::make_shared<const ForceFormula>(std::move(formula.value()));
  for (int i : TargetCylinders(effect, extension->params())) {
    if (extension->friction(i).further != nullptr) {
      return Error{"effects." + effect.name, "a second formula on one cylinder", "one"};
    }
    extension->friction(i).further = law;
  }
  return {};
}

}  // namespace

const EffectInfo& UnlistedInfo() {
  static const EffectInfo info = {"unlisted",
                                  "unlisted",
                                  "cylinders",
                                  "a force by formula",
                                  {{"c1_N", "N", 0, -1e9, 1e9, -1e5, 1e5, "coefficient"},
                                   {"c2_N", "N", 0, -1e9, 1e9, -1e5, 1e5, "coefficient"},
                                   {"c3_N", "N", 0, -1e9, 1e9, -1e5, 1e5, "coefficient"},
                                   {"c4_N", "N", 0, -1e9, 1e9, -1e5, 1e5, "coefficient"},
                                   {"c5_N", "N", 0, -1e9, 1e9, -1e5, 1e5, "coefficient"},
                                   {"c6_N", "N", 0, -1e9, 1e9, -1e5, 1e5, "coefficient"}},
                                  Install,
                                  true};
  return info;
}

}  // namespace phs::effects
