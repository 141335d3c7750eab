#include "identify/formula_rivals.h"

#include <algorithm>
#include <string>

#include "effects/catalogue.h"
#include "effects/formula.h"

namespace phs::identify::search {
namespace {

bool MeetsPlace(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  return a.empty() || b.empty() ||
         std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

}  // namespace

bool IsFormOfListedFriction(const FoundFormula& found, const std::vector<AcceptedEffect>& effects) {
  const bool friction = std::any_of(effects.begin(), effects.end(), [](const AcceptedEffect& e) {
    const auto* info = effects::Catalogue().Find(e.candidate.effect);
    return info != nullptr && info->family == "friction";
  });
  return friction && std::all_of(found.terms.begin(), found.terms.end(), [](const auto& term) {
           return term.text.starts_with("s*") || term.text.starts_with("s^") ||
                  term.text.find('v') != std::string::npos;
         });
}

bool IsFormOfListedVolume(const FoundFormula& found, const std::vector<AcceptedEffect>& effects) {
  static const std::vector<std::string> yielding = {
      "entrained_air", "hose_expansion", "accumulator_precharge", "diaphragm_stop", "cavitation"};
  if (found.unit != effects::UnitSuffix(effects::FormulaUnit::kVolume)) return false;
  return std::any_of(effects.begin(), effects.end(), [&](const AcceptedEffect& e) {
    return std::find(yielding.begin(), yielding.end(), e.candidate.effect) != yielding.end() &&
           MeetsPlace(e.candidate.params.targets, found.targets);
  });
}

bool IsFarBetter(const FitResult& formula, const FitResult& listed, const Evidence& over) {
  constexpr double kFar = 0.3;  // of the residual's rms
  constexpr size_t kChosen = 2;
  return over.estimation_gain > kFar || formula.values.size() + kChosen < listed.values.size();
}

}  // namespace phs::identify::search
