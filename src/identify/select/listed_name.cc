#include "identify/select/listed_name.h"

#include "identify/fit/accept.h"
#include "identify/fit/near_fit.h"

namespace phs::identify::search {

bool SaysMore(const FitProblem& problem, const FitResult& listed, const FormulaTrial& formula) {
  return IsBeyondChance(problem.rule(),
                        Criterion(problem, listed.score, listed.values.size()) -
                            Criterion(problem, formula.fit.score, formula.fit.values.size()),
                        kTermsTried);
}

std::optional<ListedName> FindListedName(const FitProblem& problem, const FitProblem& coarse,
                                         const FreeModel& model, const FitResult& without,
                                         const FormulaTrial& formula, const Effort& effort,
                                         const std::function<bool(double)>& go_on) {
  if (!problem.rule().names) return {};
  const std::vector<double> values(
      formula.fit.values.begin(),
      formula.fit.values.begin() + static_cast<long>(model.free.size()));
  std::vector<Point> points;
  for (const std::vector<double>* at : {&values, &without.values}) {
    points.push_back(FitNear(coarse, model, *at, {}, {.max_steps = 0, .final_slopes = true}));
    if (!points.back().ok) points.pop_back();
  }
  if (points.empty()) return {};
  const std::vector<Candidate> list = problem.forward().Candidates(model.params);
  std::optional<ListedName> best;
  for (FullTrial& trial :
       TryEffects(problem, coarse, model, without, points, list, effort, go_on)) {
    if (!trial.fit.ok) continue;
    const Evidence e = Compare(problem, without, trial.fit, static_cast<double>(list.size()));
    // At the same place: what it explains shows in the same channel.
    if (e.best_channel != formula.evidence.best_channel) continue;
    if (!Refusal(problem.rule(), e, trial.form, trial.fit).empty()) continue;
    if (SaysMore(problem, trial.fit, formula)) continue;
    if (best && !Beats(problem, trial.form, trial.fit, best->form, best->fit)) continue;
    best = ListedName{trial.form, std::move(trial.fit), e};
  }
  return best;
}

}  // namespace phs::identify::search
