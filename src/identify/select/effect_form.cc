#include "identify/select/effect_form.h"

#include "identify/fit/accept.h"
#include "identify/fit/evidence.h"
#include "identify/fit/near_fit.h"

namespace phs::identify::search {
namespace {

/// Best fit of `form` from any of the starts of its last `option`.
FitResult FitOption(const FitProblem& problem, const FreeModel& model, const FitResult& before,
                    const Candidate& form, const EffectOption& option) {
  const FreeModel whole = WithCandidate(model, form);
  const int first = static_cast<int>(before.values.size());
  FitResult best;
  for (const std::vector<double>& start : option.starts) {
    std::vector<double> values = before.values;
    values.insert(values.end(), start.begin(), start.end());
    FitResult fit =
        FitNear(problem, whole, values, before.slopes, {.first_own = first, .max_steps = 6});
    if (fit.ok && (!best.ok || fit.score < best.score)) best = std::move(fit);
  }
  return best;
}

}  // namespace

FitResult AddOptions(const FitProblem& problem, const FreeModel& model, FitResult now,
                     Candidate* form) {
  while (problem.rule().options && !form->options.empty()) {
    std::vector<FitResult> fits(form->options.size());
    problem.ForEach(static_cast<int>(fits.size()), [&](int k) {
      const auto i = static_cast<size_t>(k);
      fits[i] = FitOption(problem, model, now, WithOption(*form, i), form->options[i]);
    });
    FitResult best;
    size_t chosen = 0;
    for (size_t k = 0; k < fits.size(); ++k) {
      const size_t added = form->options[k].free.size();
      if (!fits[k].ok || !AreTold(WithOption(*form, k).free, fits[k], added)) continue;
      if (!best.ok || fits[k].score < best.score) best = std::move(fits[k]), chosen = k;
    }
    if (!best.ok) return now;
    const double gain = Criterion(problem, now.score, now.values.size()) -
                        Criterion(problem, best.score, best.values.size());
    if (!IsBeyondChance(problem.rule(), gain, static_cast<double>(fits.size()))) return now;
    *form = WithOption(*form, chosen);
    now = std::move(best);
  }
  return now;
}

void DropIdle(const FitProblem& problem, const FreeModel& model, size_t core, Candidate* form,
              FitResult* now) {
  const size_t base = model.free.size();
  for (size_t k = form->free.size(); k-- > core;) {
    Candidate less = *form;
    less.free.erase(less.free.begin() + static_cast<long>(k));
    std::vector<double> values = now->values;
    values.erase(values.begin() + static_cast<long>(base + k));
    FitResult fit = FitNear(problem, WithCandidate(model, less), values, now->slopes,
                            {.first_own = static_cast<int>(base), .max_steps = 6});
    if (!fit.ok) continue;
    const double loss = Criterion(problem, fit.score, fit.values.size()) -
                        Criterion(problem, now->score, now->values.size());
    if (IsBeyondChance(problem.rule(), loss, 1)) continue;
    *form = std::move(less), *now = std::move(fit);
  }
}

void DropEdges(const FitProblem& problem, const FreeModel& model, size_t core, Candidate* form,
               FitResult* fit) {
  const size_t base = model.free.size();
  while (problem.rule().options && fit->ok) {
    std::vector<double> values = fit->values;
    Candidate less = *form;
    for (size_t k = form->free.size(); k-- > core;) {
      if (!IsAtEnd(form->free[k], fit->values[base + k])) continue;
      less.free.erase(less.free.begin() + static_cast<long>(k));
      values.erase(values.begin() + static_cast<long>(base + k));
    }
    if (less.free.size() == form->free.size()) return;
    *form = std::move(less);
    *fit = FitNear(problem, WithCandidate(model, *form), values, {},
                   {.max_steps = 15, .final_slopes = true});
  }
}

}  // namespace phs::identify::search
