#include "identify/effect_form.h"

#include "identify/evidence.h"
#include "identify/fit_intervals.h"
#include "identify/near_fit.h"

namespace phs::identify::search {
namespace {

constexpr double kDeltaBic = 12, kGain = 0.005;  // what an option must bring
constexpr int kMostOptions = 3;

/// True if a number that came with the last option lies on a bound or could be any: then the option
/// brings nothing, whatever the refit of the others gained.
bool IsUnsettled(const Candidate& form, const FitResult& fit, size_t first) {
  constexpr double kTiny = 1e-3, kAny = 0.5;  // of its range
  const size_t base = fit.values.size() - form.free.size();
  for (size_t i = first; i < fit.values.size(); ++i) {
    const FreeParameter& p = form.free[i - base];
    const double x = p.ToCoordinate(fit.values[i]);
    const double low = p.ToCoordinate(p.low), high = p.ToCoordinate(p.high);
    if (fit.half_95[i] > kAny * (high - low)) return true;
    if (x - low < kTiny * (high - low) || high - x < kTiny * (high - low)) return true;
  }
  return false;
}

/// Best fit of `form` from any of the starts of its last `option`.
FitResult FitOption(const FitProblem& coarse, const FreeModel& model, const FitResult& before,
                    const Candidate& form, const EffectOption& option) {
  const FreeModel whole = WithCandidate(model, form);
  const int first = static_cast<int>(before.values.size());
  FitResult best;
  for (const std::vector<double>& start : option.starts) {
    std::vector<double> values = before.values;
    values.insert(values.end(), start.begin(), start.end());
    FitResult fit = FitNear(coarse, whole, values, before.jacobian,
                            {.first_own = first, .max_steps = 6, .tolerance = 1e-3});
    if (fit.ok && (!best.ok || fit.residual.squaredNorm() < best.residual.squaredNorm())) {
      best = std::move(fit);
    }
  }
  return best;
}

}  // namespace

FitResult AddOptions(const FitProblem& problem, const FreeModel& model, FitResult now,
                     Candidate* form) {
  for (int round = 0; round < kMostOptions && !form->options.empty(); ++round) {
    const FreeModel whole = WithCandidate(model, *form);
    if (!problem.Linearise(whole, now.values, 0, &now.residual, &now.jacobian)) return now;
    SetIntervals(problem, &now);
    std::vector<FitResult> fits(form->options.size());
    problem.ForEach(static_cast<int>(fits.size()), [&](int k) {
      fits[k] = FitOption(problem, model, now, WithOption(*form, k), form->options[k]);
    });
    FitResult best;
    size_t chosen = 0;
    for (size_t k = 0; k < fits.size(); ++k) {
      FitResult& with = fits[k];
      if (!with.ok || IsUnsettled(WithOption(*form, k), with, now.values.size())) continue;
      if (!best.ok || with.residual.squaredNorm() < best.residual.squaredNorm()) {
        best = std::move(with), chosen = k;
      }
    }
    if (!best.ok) return now;
    const Evidence e = Compare(problem, now, best);
    if (e.delta_bic < kDeltaBic || e.estimation_gain < kGain) return now;
    *form = WithOption(*form, chosen);
    now = std::move(best);
  }
  return now;
}

FitResult ShapeForm(const FitProblem& coarse, const FreeModel& model, const FitResult& fit,
                    Candidate* form) {
  // Settled first, so that no option is credited with what a few more steps bring.
  FitResult now = FitNear(coarse, WithCandidate(model, *form), fit.values, {}, {.max_steps = 4});
  if (!now.ok) now = fit;
  return AddOptions(coarse, model, std::move(now), form);
}

}  // namespace phs::identify::search
