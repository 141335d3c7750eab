#include "identify/effect_reshape.h"

#include <algorithm>
#include <map>

#include "identify/effect_options.h"
#include "identify/effect_trials.h"
#include "identify/effect_verdict.h"
#include "identify/fit_intervals.h"
#include "identify/near_fit.h"

namespace phs::identify::search {
namespace {

/// The first effect goes behind all others, and its numbers in what the fit says.
void MoveFirstToEnd(const FitProblem& problem, Identification* found) {
  const auto first = static_cast<long>(found->declared.free.size());
  const auto n = static_cast<long>(found->effects.front().candidate.free.size());
  FitResult& fit = found->after;
  std::rotate(fit.values.begin() + first, fit.values.begin() + first + n, fit.values.end());
  const Eigen::MatrixXd moved = fit.jacobian.middleCols(first, n);
  const auto behind = fit.jacobian.cols() - first - n;
  fit.jacobian.middleCols(first, behind) = fit.jacobian.rightCols(behind).eval();
  fit.jacobian.rightCols(n) = moved;
  SetIntervals(problem, &fit);
  std::rotate(found->effects.begin(), found->effects.begin() + 1, found->effects.end());
}

void Take(const FreeModel& model, FullTrial&& trial, Identification* found) {
  AcceptedEffect& effect = found->effects.back();
  const std::string old = effect.candidate.effect;
  effect.candidate = trial.form;
  found->corrected = WithCandidate(model, trial.form);
  found->after = std::move(trial.fit);
  if (trial.form.effect == old) return;
  effect.confusable_with.push_back(old);
  Withdraw(old, "a simpler effect that it contains suffices", &found->candidates);
  found->candidates.push_back(
      {trial.form.effect, VariantName(trial.form), 0, 0, 0, true, effect.evidence, "accepted"});
}

/// The forms of each effect that were worth a full fit when it was first tried anew.
using Promising = std::map<std::string, std::vector<Candidate>>;

/// Tries the first effect anew and moves it to the end: at first in all its forms, from the
/// declared numbers too, later in the promising ones. True if that changed what is explained.
bool ReshapeFirst(const FitProblem& problem, const FitProblem& coarse, const SearchOptions& options,
                  const std::function<bool(double)>& tick, Promising* promising,
                  Identification* found) {
  constexpr double kGain = 0.01;  // enough to look at the others again
  FreeModel model;
  FitResult rest;
  rest.values = ValuesWithout(*found, 0, &model);
  std::vector<double> declared = rest.values;
  for (size_t i = 0; i < found->declared.free.size(); ++i) {
    declared[i] = found->declared.free[i].start;
  }
  const std::string name = found->effects.front().candidate.effect;
  std::vector<std::vector<double>> points = {rest.values};
  std::vector<Candidate> list;
  if (promising->contains(name)) {
    list = promising->at(name);
  } else {
    list = problem.forward().Candidates(model.params);
    std::erase_if(
        list, [&](const Candidate& c) { return c.effect != name && !IsNested(c.effect, name); });
    points.push_back(std::move(declared));
  }
  double reference = 0;
  std::vector<FullTrial> trials = TryEffects(problem, coarse, model, rest, list,
                                             {.coarse_fits = 6,
                                              .full_fits = 4,
                                              .each = 2,
                                              .thorough = true,
                                              .declared = found->declared.free.size(),
                                              .points = std::move(points)},
                                             tick, &reference);
  std::vector<Candidate>& fitted = (*promising)[name];
  fitted.clear();
  for (const FullTrial& trial : trials) {
    if (trial.fit.ok) fitted.push_back(*trial.candidate);
  }
  MoveFirstToEnd(problem, found);
  found->corrected = WithCandidate(model, found->effects.back().candidate);
  bool changed = false;
  for (FullTrial& trial : trials) {
    if (!trial.fit.ok || OnBound(WithCandidate(model, trial.form), trial.fit, trial.form)) continue;
    const Evidence e = Compare(problem, found->after, trial.fit);
    const bool better = e.delta_bic > options.min_delta_bic && e.estimation_gain > 0;
    if (!better && !FitsAsWellWithFewer(problem, trial.fit, found->after)) continue;
    changed |= e.estimation_gain > kGain;
    Take(model, std::move(trial), found);
  }
  return changed;
}

}  // namespace

std::vector<double> ValuesWithout(const Identification& found, size_t dropped, FreeModel* model) {
  *model = found.declared;
  const std::vector<double>& all = found.after.values;
  size_t at = model->free.size();
  std::vector<double> values(all.begin(), all.begin() + static_cast<long>(at));
  for (size_t i = 0; i < found.effects.size(); ++i) {
    const Candidate& c = found.effects[i].candidate;
    if (i != dropped) {
      *model = WithCandidate(*model, c);
      for (size_t k = 0; k < c.free.size(); ++k) values.push_back(all[at + k]);
    }
    at += c.free.size();
  }
  return values;
}

FitResult FitWithout(const FitProblem& problem, const Identification& found, size_t dropped,
                     FreeModel* model) {
  const std::vector<double> start = ValuesWithout(found, dropped, model);
  FitResult fit = FitNear(problem, *model, start, {}, {.first_own = 0, .max_steps = 1});
  if (!fit.ok) return fit;
  return FitBalanced(
      problem, *model, fit.values, fit.jacobian,
      {.first_own = static_cast<int>(model->free.size()), .max_steps = 8, .final_jacobian = true});
}

bool FitsAsWellWithFewer(const FitProblem& problem, const FitResult& simple, const FitResult& other,
                         double margin) {
  constexpr double kSame = 0.005, kSameChannel = 0.01;  // of the residual's rms
  if (simple.values.size() >= other.values.size()) return false;
  const Evidence e = Compare(problem, simple, other);
  return e.estimation_gain < margin * kSame && e.best_channel_gain < margin * kSameChannel;
}

void ReshapeEffects(const FitProblem& problem, const FitProblem& coarse,
                    const SearchOptions& options, const std::function<bool(double)>& tick,
                    Identification* found) {
  constexpr int kPasses = 2;
  const int count = static_cast<int>(found->effects.size());
  int since = 0;  // effects looked at since one changed
  int k = 0;
  Promising promising;
  for (; k < kPasses * count && since < count && tick(0); ++k) {
    since = ReshapeFirst(problem, coarse, options, tick, &promising, found) ? 1 : since + 1;
  }
  for (; k % count != 0; ++k) {  // back in the order of their acceptance
    FreeModel rest;
    ValuesWithout(*found, 0, &rest);
    MoveFirstToEnd(problem, found);
    found->corrected = WithCandidate(rest, found->effects.back().candidate);
  }
}

}  // namespace phs::identify::search
