#include "identify/select/own_form.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "effects/unlisted.h"

namespace phs::identify::search {
namespace {

using effects::Formula;
using effects::FormulaUnit;
using hydraulics::EffectInfo;

/// Over no other variables than the law, and beginning at a value where the law always does.
bool IsOver(const FoundFormula& formula, const hydraulics::LawOver& law_over) {
  if (law_over.always_begins && formula.text.find("max(") == std::string::npos) return false;
  const std::string variables = law_over.variables;
  std::map<std::string, double> coefficients;
  for (size_t k = 0; k < formula.coefficients.size(); ++k) {
    coefficients["c" + std::to_string(k + 1)] = 1;
  }
  for (const FormulaUnit unit : {FormulaUnit::kForce, FormulaUnit::kVolume, FormulaUnit::kFlow,
                                 FormulaUnit::kLength, FormulaUnit::kPressure}) {
    if (formula.unit != effects::UnitSuffix(unit)) continue;
    const Result<Formula> law = Formula::Parse(formula.text, coefficients, unit);
    return law.ok() && law.value().VariableOtherThan(variables).empty();
  }
  return false;
}

/// A force acts on the one piston of a rig that has formulas of force, a gauge belongs to the one
/// cylinder of such a rig; other formulas act on cylinders or on lines as the effect does. What
/// surrounds the rig acts everywhere.
bool IsAtSuchPlaces(const FoundFormula& formula, const EffectInfo& info,
                    const hydraulics::PhsParams& params) {
  const std::vector<std::string>& on = formula.targets;
  if (formula.unit == effects::UnitSuffix(FormulaUnit::kForce) || info.targets.empty()) return true;
  if (formula.unit == effects::UnitSuffix(FormulaUnit::kPressure)) return true;
  const bool cylinders = std::all_of(on.begin(), on.end(), [&](const std::string& name) {
    return params.FindCylinder(name) >= 0 && params.FindLine(name) < 0;
  });
  return !on.empty() && info.targets == (cylinders ? "cylinders" : "lines");
}

/// At such places, and at none that the effect does not act on.
bool ActsThere(const FoundFormula& formula, const EffectInfo& info, const Candidate& effect,
               const hydraulics::PhsParams& params) {
  if (!IsAtSuchPlaces(formula, info, params)) return false;
  if (formula.unit == effects::UnitSuffix(FormulaUnit::kForce)) return true;
  const std::vector<std::string>& on = formula.targets;
  const std::vector<std::string>& all = effect.params.targets;
  return all.empty() || std::all_of(on.begin(), on.end(), [&](const std::string& name) {
           return std::find(all.begin(), all.end(), name) != all.end();
         });
}

/// True if one law of the catalogue alone is over the formula's variables.
bool IsOfOneLawAlone(const FoundFormula& formula, const hydraulics::PhsParams& params) {
  int laws = 0;
  for (const EffectInfo& info : effects::Catalogue().effects()) {
    if (formula.unit != info.search.over.unit || !IsAtSuchPlaces(formula, info, params)) continue;
    laws += IsOver(formula, info.search.over) ? 1 : 0;
  }
  return laws == 1;
}

}  // namespace

bool IsFormula(const AcceptedEffect& effect) {
  return effect.candidate.effect == effects::UnlistedInfo().name;
}

std::optional<size_t> HasOwnForm(const Identification& found) {
  const auto own = std::find_if(found.effects.begin(), found.effects.end(), IsFormula);
  if (own == found.effects.end() || found.formula.empty()) return {};
  const bool alone = IsOfOneLawAlone(found.formula, found.corrected.params);
  const bool gauge = found.formula.unit == effects::UnitSuffix(FormulaUnit::kPressure);
  const double least = alone ? 0 : own->evidence.delta_bic;
  std::optional<size_t> host;
  for (size_t i = 0; i < found.effects.size(); ++i) {
    const AcceptedEffect& effect = found.effects[i];
    const EffectInfo* info = effects::Catalogue().Find(effect.candidate.effect);
    if (info == nullptr || effect.evidence.delta_bic <= least) continue;
    if (host && effect.evidence.delta_bic <= found.effects[*host].evidence.delta_bic) continue;
    if (found.formula.unit != info->search.over.unit) continue;
    if (gauge && effect.evidence.best_channel != own->evidence.best_channel) continue;
    if (!ActsThere(found.formula, *info, effect.candidate, found.corrected.params)) continue;
    if (IsOver(found.formula, info->search.over)) host = i;
  }
  return host;
}

}  // namespace phs::identify::search
