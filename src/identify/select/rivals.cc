#include "identify/select/rivals.h"

#include <algorithm>

#include "identify/fit/accept.h"
#include "identify/fit/evidence.h"

namespace phs::identify::search {
namespace {

Rival Numbers(const FullTrial& trial) {
  const auto own = static_cast<long>(trial.form.free.size());
  return {trial.form, {trial.fit.values.end() - own, trial.fit.values.end()}};
}

/// By how much the criterion of `other` is above that of `best`; no more than what lies above the
/// known errors of what drives the model.
double Behind(const FitProblem& problem, const FitResult& other, const FitResult& best) {
  const double behind = Criterion(problem, other.score, other.values.size()) -
                        Criterion(problem, best.score, best.values.size());
  const Likelihood& likelihood = problem.likelihood();
  if (!likelihood.has_inputs()) return behind;
  const double above = Criterion(problem, likelihood.MostGain(other.powers), other.values.size()) -
                       Criterion(problem, likelihood.MostGain(best.powers), best.values.size());
  return std::min(behind, above);
}

}  // namespace

AcceptedEffect BesideRivals(const FitProblem& problem, const FullTrial& trial,
                            const Evidence& evidence, const std::vector<FullTrial>& others) {
  AcceptedEffect accepted{trial.form, evidence, {}};
  for (const FullTrial& other : others) {
    const bool same = other.candidate->effect == trial.candidate->effect;
    if (same && !IsElsewhere(other.form, trial.form)) continue;
    if (IsBeyondChance(problem.rule(), Behind(problem, other.fit, trial.fit), 1)) continue;
    const bool larger = problem.rule().plain_first &&
                        Contains(other.form, trial.form);  // it shows all that its part does
    const std::string name = NameBeside(other.form, trial.form);
    std::vector<std::string>& known = larger ? accepted.special_case_of : accepted.confusable_with;
    if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
    if (!larger) accepted.rivals.push_back(Numbers(other));
  }
  return accepted;
}

}  // namespace phs::identify::search
