#include "identify/select/formula_rounds.h"

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"
#include "effects/unlisted.h"
#include "identify/discrepancy/driven_formula.h"
#include "identify/fit/accept.h"
#include "identify/fit/near_fit.h"
#include "identify/select/listed_name.h"
#include "identify/select/own_form.h"
#include "identify/select/passivity.h"

namespace phs::identify::search {
namespace {

void Record(const FormulaTrial& trial, const std::string& verdict, Identification* found) {
  found->candidates.push_back({effects::UnlistedInfo().name, trial.found.text, 0, trial.found.gain,
                               true, trial.evidence, verdict});
}

void Take(const FormulaTrial& trial, Identification* found) {
  Record(trial, kAccepted, found);
  found->effects.push_back({trial.candidate, trial.evidence, {}});
  found->corrected = trial.model, found->after = trial.fit, found->formula = trial.found;
}

/// A listed effect in the place of the formula, on top of `model`.
void Take(const FreeModel& model, const ListedName& name, const FormulaTrial& formula,
          Identification* found) {
  Record(formula, "is a listed effect: " + name.form.effect, found);
  found->candidates.push_back(
      {name.form.effect, VariantName(name.form), 0, 0, true, name.evidence, kAccepted});
  found->effects.push_back({name.form, name.evidence, {}});
  found->corrected = WithCandidate(model, name.form), found->after = name.fit;
}

/// What chance alone does to the criterion: that of each term, as of an effect.
double Threshold(const FitProblem& problem) {
  return -2 * std::log(problem.rule().accept.false_alarms);
}

/// The effect of which the formula is another form: beside it, it would say what it says more. What
/// begins at a value (a valve that opens) is no form of a law that does not (a leak).
std::optional<size_t> FormOf(const FitProblem& problem, const FormulaTrial& trial,
                             const Identification& found) {
  Identification with = found;
  with.formula = trial.found;
  with.effects.push_back({trial.candidate, trial.evidence, {}});
  with.effects.back().evidence.delta_bic =
      Criterion(problem, found.after.score, found.after.values.size()) -
      Criterion(problem, trial.fit.score, trial.fit.values.size());
  const std::optional<size_t> host = HasOwnForm(with);
  if (!host || trial.found.text.find("max(") == std::string::npos) return host;
  const hydraulics::EffectInfo* info =
      effects::Catalogue().Find(found.effects[*host].candidate.effect);
  return info->search.over.begins ? host : std::nullopt;
}

/// `found` with the core of effect `kept` alone, and what a formula says beside it.
Identification FormBeside(const FitProblem& problem, const FitProblem& coarse, const Effort& effort,
                          const std::function<bool(double)>& go_on, size_t kept,
                          Identification found) {
  for (size_t i = found.effects.size(); i-- > 0;) {
    if (i == kept) continue;
    FreeModel model;
    found.after.values = ValuesWithout(found, i, &model);
    found.corrected = std::move(model);
    Withdraw(found.effects[i].candidate.effect, "a formula says more", &found.candidates);
    found.effects.erase(found.effects.begin() + static_cast<long>(i));
  }
  KeepCore(&found);
  found.after = FitNear(problem, found.corrected, found.after.values, {},
                        {.max_steps = 8, .final_slopes = true});
  const bool room = effort.max_effects > 1;  // formulas count
  if (found.after.ok && room) AddFormula(problem, coarse, effort, go_on, &found);
  return found;
}

/// The formula that these limits allow takes the place of all effects, where it says more.
void Challenge(const FitProblem& problem, const FitProblem& coarse, const Effort& effort,
               const std::function<bool(double)>& go_on, const FormulaLimits& limits,
               Identification* found) {
  const FormulaTrial trial = TryFormula(problem, coarse, found->declared, found->base, limits);
  if (!trial.fit.ok) return;
  const bool alone = Refusal(problem.rule(), trial.evidence, trial.candidate, trial.fit).empty();
  if (!alone || !SaysMore(problem, found->after, trial)) return Record(trial, kBeaten, found);
  if (const std::optional<size_t> host = FormOf(problem, trial, *found)) {
    Record(trial, "another form of " + found->effects[*host].candidate.effect, found);
    Identification beside = FormBeside(problem, coarse, effort, go_on, *host, *found);
    if (beside.after.ok && !SaysMore(problem, beside.after, trial)) *found = std::move(beside);
    return;
  }
  for (const AcceptedEffect& effect : found->effects) {
    Withdraw(effect.candidate.effect, "a formula on no list explains more", &found->candidates);
  }
  found->effects.clear();
  const auto name =
      FindListedName(problem, coarse, found->declared, found->base, trial, effort, go_on);
  name ? Take(found->declared, *name, trial, found) : Take(trial, found);
}

bool HasInstrument(const Identification& found) {
  return std::any_of(found.effects.begin(), found.effects.end(),
                     [](const AcceptedEffect& e) { return IsOfInstrument(e.candidate); });
}

}  // namespace

void ChallengeByFormula(const FitProblem& problem, const FitProblem& coarse, const Effort& effort,
                        const std::function<bool(double)>& go_on, Identification* found) {
  if (found->effects.empty() || !problem.rule().challenge) return;
  FormulaLimits limits{.max_terms = 1, .threshold = Threshold(problem)};
  Challenge(problem, coarse, effort, go_on, limits, found);
  if (!HasInstrument(*found)) return;
  limits = {.threshold = Threshold(problem), .readings = false};
  Challenge(problem, coarse, effort, go_on, limits, found);
}

bool AddFormula(const FitProblem& problem, const FitProblem& coarse, const Effort& effort,
                const std::function<bool(double)>& go_on, Identification* found) {
  if (!found->formula.empty()) return false;
  FormulaLimits limits{.threshold = Threshold(problem)};
  FormulaTrial trial;
  std::string no;
  do {  // where the record does not tell the amounts of several terms apart, fewer do
    trial = TryFormula(problem, coarse, found->corrected, found->after, limits);
    if (!trial.fit.ok) return false;
    no = Refusal(problem.rule(), trial.evidence, trial.candidate, trial.fit);
    if (!no.empty()) Record(trial, no, found);
    limits.max_terms = static_cast<int>(trial.found.terms.size()) - 1;
  } while (no == kNotTold && limits.max_terms > 0);
  if (!no.empty()) return false;
  const auto name =
      FindListedName(problem, coarse, found->corrected, found->after, trial, effort, go_on);
  Identification with = *found;
  name ? Take(found->corrected, *name, trial, &with) : Take(trial, &with);
  // Alone it says that something with a supply of its own is there; beside effects it bends one.
  if (!found->effects.empty() && !WhatDrives(problem, with).empty()) {
    Record(trial, "drives where it must dissipate", found);
    return false;
  }
  *found = std::move(with);
  return true;
}

}  // namespace phs::identify::search
