#include "identify/select/trials.h"

#include <algorithm>
#include <atomic>

#include "identify/fit/accept.h"
#include "identify/fit/evidence.h"
#include "identify/fit/near_fit.h"
#include "identify/select/effect_form.h"

namespace phs::identify::search {
namespace {

/// The best variants of the best effects, two of each and three times as many as are fitted in
/// full: what options bring shows only when they are there.
std::vector<size_t> BestOfEach(const std::vector<FullTrial>& trials, size_t most) {
  constexpr long kOfOne = 2;
  std::vector<size_t> chosen;
  for (size_t i = 0; i < trials.size() && chosen.size() < most; ++i) {
    if (!trials[i].coarse.ok) continue;
    const auto known = std::count_if(chosen.begin(), chosen.end(), [&](size_t k) {
      return trials[k].candidate->effect == trials[i].candidate->effect;
    });
    if (known < kOfOne) chosen.push_back(i);
  }
  return chosen;
}

/// Of these, best first: the best variant of `most` effects, so that one which comes in many forms
/// keeps no other out, and the second variant of the first half of them.
std::vector<size_t> FittedInFull(const std::vector<FullTrial>& trials,
                                 const std::vector<size_t>& chosen, size_t most) {
  std::vector<size_t> first, second;
  const auto has = [&](const std::vector<size_t>& list, size_t length, size_t k) {
    return std::any_of(list.begin(), list.begin() + static_cast<long>(length), [&](size_t other) {
      return trials[other].candidate->effect == trials[k].candidate->effect;
    });
  };
  for (const size_t k : chosen) {
    if (!has(first, first.size(), k) && first.size() < most) {
      first.push_back(k);
    } else if (has(first, std::min(first.size(), most / 2), k) && !has(second, second.size(), k)) {
      second.push_back(k);
    }
  }
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Where the full fit of a candidate begins: the numbers of its coarse fit. A thinned record may
/// mislead (a line that rings faster than its samples seems damped): where these say less than
/// nothing on the full one, what is best there of neighbours of each number and of the candidate's
/// own starts.
std::vector<double> FullStart(const FitProblem& problem, const FreeModel& whole,
                              const FitResult& without, const FullTrial& trial) {
  const std::vector<double>& coarse = trial.coarse.values;
  const auto score = [&](const std::vector<double>& values) {
    const Eigen::VectorXd residual = problem.Residual(whole, values);
    return residual.size() > 0 ? problem.likelihood().MinusTwoLog(residual) : 1e300;
  };
  double least = score(coarse);
  if (least < without.score) return coarse;
  const size_t first = without.values.size();
  std::vector<std::vector<double>> tried;
  for (const std::vector<double>& start : trial.candidate->starts) {
    tried.push_back(coarse);
    std::copy(start.begin(), start.end(), tried.back().begin() + static_cast<long>(first));
  }
  for (size_t i = first; i < coarse.size(); ++i) {
    const FreeParameter& p = whole.free[i];
    if (!p.logarithmic) continue;
    for (const double factor : {0.1, 0.3, 3.0, 10.0}) {
      tried.push_back(coarse);
      tried.back()[i] = std::clamp(factor * coarse[i], p.low, p.high);
    }
  }
  std::vector<double> best = coarse;
  for (std::vector<double>& values : tried) {
    const double here = score(values);
    if (here < least) least = here, best = std::move(values);
  }
  return best;
}

/// False if a fit gains too little for the rule even with the `core` of its numbers alone, or takes
/// too little of what is left: then nobody asks for its slopes and intervals.
bool MayPass(const FitProblem& problem, const FitResult& without, const FitResult& with,
             size_t core, double tried) {
  if (!with.ok) return false;
  const Evidence e = Compare(problem, without, with, tried);
  const double gain = without.score - with.score - Criterion(problem, 0, core);
  return IsBeyondChance(problem.rule(), gain, tried) &&
         e.share >= problem.rule().accept.least_share;
}

}  // namespace

std::vector<FullTrial> TryEffects(const FitProblem& problem, const FitProblem& coarse,
                                  const FreeModel& model, const FitResult& fit,
                                  const std::vector<Point>& points,
                                  const std::vector<Candidate>& list, const Effort& effort,
                                  const std::function<bool(double)>& go_on, KnownAnswers* known) {
  constexpr double kScreening = 0.5, kForms = 0.25;  // of the work
  std::vector<FullTrial> trials;
  for (Trial& trial : ScreenCandidates(
           coarse, model, points, list, effort,
           [&](double part) { return go_on(kScreening * part); }, known)) {
    trials.push_back({trial.candidate,
                      *trial.candidate,
                      std::move(trial.coarse),
                      {},
                      trial.promise,
                      trial.fails});
  }
  const auto fits = static_cast<size_t>(effort.full_fits);
  std::vector<size_t> chosen = BestOfEach(trials, 3 * fits);
  std::atomic<int> done{0};
  problem.ForEach(static_cast<int>(chosen.size()), [&](int k) {
    if (!go_on(kScreening + kForms * done++ / static_cast<double>(chosen.size()))) return;
    FullTrial& trial = trials[chosen[static_cast<size_t>(k)]];
    if (!(trial.coarse.score < points.front().score)) return;  // nothing that could have a form
    trial.coarse = AddOptions(coarse, model, std::move(trial.coarse), &trial.form, effort);
    trial.promise = Criterion(coarse, trial.coarse.score, trial.coarse.values.size());
  });
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](size_t a, size_t b) { return trials[a].promise < trials[b].promise; });
  chosen = FittedInFull(trials, chosen, fits);
  done = 0;
  problem.ForEach(static_cast<int>(chosen.size()), [&](int k) {
    if (!go_on(kScreening + kForms + (1 - kScreening - kForms) * done++ / chosen.size())) return;
    FullTrial& trial = trials[chosen[static_cast<size_t>(k)]];
    const size_t core = trial.candidate->free.size();
    DropIdle(coarse, model, core, &trial.form, &trial.coarse);
    const FreeModel whole = WithCandidate(model, trial.form);
    trial.fit = FitNear(problem, whole, FullStart(problem, whole, fit, trial), {},
                        {.first_own = 0, .max_steps = 1, .intervals = false});
    if (!trial.fit.ok) return;
    trial.fit = FitNear(problem, whole, trial.fit.values, trial.fit.slopes,
                        {.first_own = static_cast<int>(whole.free.size()), .max_steps = 15});
    const bool asked = effort.unpromising;
    if (!asked && !MayPass(problem, fit, trial.fit, core, static_cast<double>(list.size()))) return;
    trial.fit =
        FitNear(problem, whole, trial.fit.values, {}, {.max_steps = 0, .final_slopes = true});
    DropEdges(problem, model, core, &trial.form, &trial.fit);
  });
  return trials;
}

}  // namespace phs::identify::search
