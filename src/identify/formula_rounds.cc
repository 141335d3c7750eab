#include "identify/formula_rounds.h"

#include <algorithm>

#include "identify/driven_formula.h"
#include "identify/effect_verdict.h"
#include "identify/formula_rivals.h"

namespace phs::identify::search {
namespace {

constexpr const char* kOverruled =
    "an effect explains far more, with numbers that are not plausible";
constexpr const char* kTheirForm = "no more than the form of a listed effect";

void Record(const FormulaTrial& trial, const std::string& verdict, Identification* found) {
  found->candidates.push_back({"unlisted", trial.found.text, 0, trial.found.gain, trial.found.gain,
                               true, trial.evidence, verdict});
}

void Take(const FormulaTrial& trial, Identification* found) {
  Record(trial, "accepted", found);
  found->effects.push_back({trial.candidate, trial.evidence, {}});
  found->corrected = trial.model, found->after = trial.fit, found->formula = trial.found;
}

/// True if nothing was accepted and an effect whose numbers are not plausible explains far more
/// than a formula.
bool IsOverruled(const Evidence& formula, const Identification& found) {
  constexpr double kFar = 0.1;  // of the residual's rms
  return found.effects.empty() &&
         std::any_of(found.candidates.begin(), found.candidates.end(), [&](const auto& record) {
           return record.verdict == kNotPlausible &&
                  record.evidence.estimation_gain > formula.estimation_gain + kFar;
         });
}

}  // namespace

void ChallengeByFormula(const FitProblem& problem, const FitProblem& coarse,
                        const SearchOptions& options, Identification* found) {
  if (!options.formula || found->effects.empty()) return;
  const FormulaTrial trial = TryFormula(problem, coarse, found->declared, found->before,
                                        {.max_terms = 1, .threshold = options.min_delta_bic});
  if (!trial.fit.ok || IsFormOfListedFriction(trial.found, found->effects)) return;
  const Evidence over = Compare(problem, found->after, trial.fit);
  SearchOptions rules = options;
  // With fewer numbers it need not take a large share of what the others leave; where several
  // effects are bent to one form, it need only say as much as they.
  constexpr size_t kChosen = 2;  // the formula's form and place
  if (trial.fit.values.size() < found->after.values.size()) rules.min_first_removed = 0;
  if (found->effects.size() > 1 && trial.fit.values.size() + kChosen < found->after.values.size()) {
    rules.min_gain = 0;
  }
  const bool form = IsFormOfListedVolume(trial.found, found->effects) &&
                    !IsFarBetter(trial.fit, found->after, over);
  if (form || !Verdict(over, false, true, rules).empty()) {
    if (found->effects.size() == 1) {
      NoteConfusable(problem, found->after, trial.fit, "unlisted", options,
                     &found->effects.front());
    }
    return Record(trial, form ? kTheirForm : kBeaten, found);
  }
  for (const AcceptedEffect& effect : found->effects) {
    Withdraw(effect.candidate.effect, "a formula on no list explains more", &found->candidates);
  }
  found->effects.clear();
  Take(trial, found);
}

bool AddFormula(const FitProblem& problem, const FitProblem& coarse, const SearchOptions& options,
                Identification* found) {
  if (!options.formula || !found->formula.empty()) return false;
  const FormulaTrial trial = TryFormula(problem, coarse, found->corrected, found->after,
                                        {.threshold = options.min_delta_bic});
  if (!trial.fit.ok || IsFormOfListedFriction(trial.found, found->effects)) return false;
  std::string no =
      FormulaVerdict(trial.evidence, trial.channel_gain, found->effects.empty(), options);
  if (no.empty() && IsOverruled(trial.evidence, *found)) no = kOverruled;
  if (IsFormOfListedVolume(trial.found, found->effects)) no = kTheirForm;
  if (no.empty()) {
    Take(trial, found);
  } else {
    Record(trial, no, found);
  }
  return no.empty();
}

}  // namespace phs::identify::search
