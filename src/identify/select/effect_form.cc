#include "identify/select/effect_form.h"

#include <algorithm>

#include "identify/fit/accept.h"
#include "identify/fit/evidence.h"
#include "identify/fit/fit_intervals.h"
#include "identify/fit/near_fit.h"

namespace phs::identify::search {
namespace {

/// An option of a form, and the best fit with it so far.
struct OptionTrial {
  Candidate form;
  FitResult fit;
};

/// The form with one more `option`: the best fit of `steps` from any of its starts.
OptionTrial TryOption(const FitProblem& problem, const FreeModel& model, const FitResult& before,
                      const Candidate& form, size_t option, int steps) {
  OptionTrial trial{WithOption(form, option), {}};
  const FreeModel whole = WithCandidate(model, trial.form);
  const int first = static_cast<int>(before.values.size());
  for (const std::vector<double>& start : form.options[option].starts) {
    std::vector<double> values = before.values;
    values.insert(values.end(), start.begin(), start.end());
    FitResult fit = FitNear(problem, whole, values, before.slopes,
                            {.first_own = first, .max_steps = steps, .intervals = false});
    if (fit.ok && (!trial.fit.ok || fit.score < trial.fit.score)) trial.fit = std::move(fit);
  }
  return trial;
}

void SortByScore(std::vector<OptionTrial>* trials) {
  std::stable_sort(trials->begin(), trials->end(), [](const OptionTrial& a, const OptionTrial& b) {
    return a.fit.score < b.fit.score;
  });
}

}  // namespace

FitResult AddOptions(const FitProblem& problem, const FreeModel& model, FitResult now,
                     Candidate* form, const Effort& effort) {
  constexpr int kSteps = 6;
  const bool few = effort.option_fits > 0;
  while (problem.rule().options && !form->options.empty()) {
    const int first = static_cast<int>(now.values.size());
    const size_t core = form->free.size();
    std::vector<OptionTrial> trials(form->options.size());
    const auto tried = static_cast<double>(trials.size());
    problem.ForEach(static_cast<int>(trials.size()), [&](int k) {
      const auto i = static_cast<size_t>(k);
      trials[i] = TryOption(problem, model, now, *form, i, few ? 1 : kSteps);
    });
    std::erase_if(trials, [](const OptionTrial& t) { return !t.fit.ok; });
    SortByScore(&trials);
    if (few) {
      trials.resize(std::min(trials.size(), static_cast<size_t>(effort.option_fits)));
      problem.ForEach(static_cast<int>(trials.size()), [&](int k) {
        OptionTrial& t = trials[static_cast<size_t>(k)];
        FitResult on = FitNear(problem, WithCandidate(model, t.form), t.fit.values, t.fit.slopes,
                               {.first_own = first, .max_steps = kSteps, .intervals = false});
        if (on.ok && on.score <= t.fit.score) t.fit = std::move(on);
      });
      SortByScore(&trials);
    }
    const auto best = std::find_if(trials.begin(), trials.end(), [&](OptionTrial& t) {
      SetIntervals(problem, &t.fit);
      return AreTold(t.form.free, t.fit, t.form.free.size() - core);
    });
    if (best == trials.end()) return now;
    const double gain = Criterion(problem, now.score, now.values.size()) -
                        Criterion(problem, best->fit.score, best->fit.values.size());
    if (!IsBeyondChance(problem.rule(), gain, tried)) return now;
    *form = std::move(best->form), now = std::move(best->fit);
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
    FitResult fit =
        FitNear(problem, WithCandidate(model, less), values, now->slopes,
                {.first_own = static_cast<int>(base), .max_steps = 6, .intervals = false});
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
