#include "identify/formula_rounds.h"

#include <cmath>

#include "effects/unlisted.h"
#include "identify/accept.h"
#include "identify/driven_formula.h"

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

/// What chance alone does to the criterion: that of each term, as of an effect.
double Threshold() { return -2 * std::log(Acceptance().false_alarms); }

}  // namespace

void ChallengeByFormula(const FitProblem& problem, const FitProblem& coarse,
                        Identification* found) {
  if (found->effects.empty()) return;
  const FormulaTrial trial = TryFormula(problem, coarse, found->declared, found->base,
                                        {.max_terms = 1, .threshold = Threshold()});
  if (!trial.fit.ok) return;
  const double ahead = Criterion(problem, found->after.score, found->after.values.size()) -
                       Criterion(problem, trial.fit.score, trial.fit.values.size());
  const bool alone = Refusal(trial.evidence, trial.candidate, trial.fit).empty();
  if (!alone || !IsBeyondChance(ahead, kTermsTried)) return Record(trial, kBeaten, found);
  for (const AcceptedEffect& effect : found->effects) {
    Withdraw(effect.candidate.effect, "a formula on no list explains more", &found->candidates);
  }
  found->effects.clear();
  Take(trial, found);
}

bool AddFormula(const FitProblem& problem, const FitProblem& coarse, Identification* found) {
  if (!found->formula.empty()) return false;
  const FormulaTrial trial =
      TryFormula(problem, coarse, found->corrected, found->after, {.threshold = Threshold()});
  if (!trial.fit.ok) return false;
  const std::string no = Refusal(trial.evidence, trial.candidate, trial.fit);
  if (no.empty()) {
    Take(trial, found);
  } else {
    Record(trial, no, found);
  }
  return no.empty();
}

}  // namespace phs::identify::search
