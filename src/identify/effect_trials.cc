#include "identify/effect_trials.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>

#include "identify/effect_form.h"
#include "identify/evidence.h"
#include "identify/near_fit.h"
namespace phs::identify::search {
namespace {

bool AreApart(const FreeModel& model, const std::vector<double>& a, const std::vector<double>& b,
              double least) {
  for (size_t i = 0; i < a.size(); ++i) {
    const FreeParameter& p = model.free[i];
    if (p.logarithmic && std::abs(p.ToCoordinate(a[i]) - p.ToCoordinate(b[i])) > least) return true;
  }
  return false;
}

/// Where candidates are tried: the best fit and, where it lies elsewhere, the fit to what most of
/// the record says; a rare strong deviation may have drawn the first far off.
std::vector<std::vector<double>> Points(const FitProblem& coarse, const FreeModel& model,
                                        const FitResult& fit, const TrialOptions& options) {
  constexpr double kElsewhere = 0.03;
  std::vector<std::vector<double>> points = {fit.values};
  if (!options.elsewhere) return points;
  std::vector<double> start = fit.values;
  for (size_t i = 0; i < options.declared; ++i) start[i] = model.free[i].start;
  const FitResult most = FitNear(coarse, model, start, {}, {.max_steps = 12, .robust = 2.5});
  if (most.ok && AreApart(model, most.values, fit.values, kElsewhere)) {
    points.push_back(most.values);
  }
  return points;
}

/// A strong effect may have bent the baseline so far that its own numbers have no way back from
/// there: where the volumes have moved far, hydraulic effects start from the declared model too.
bool AddDeclaredPoint(const FreeModel& model, size_t declared,
                      std::vector<std::vector<double>>* points) {
  constexpr double kFar = 0.2;
  std::vector<double> volumes = points->front(), all = volumes;
  for (size_t i = 0; i < declared; ++i) {
    all[i] = model.free[i].start;
    if (model.free[i].name.ends_with("_volume_m3")) volumes[i] = all[i];
  }
  for (const auto& point : *points) {
    if (!AreApart(model, volumes, point, kFar)) return false;
  }
  points->push_back(std::move(all));
  return true;
}

/// The first trials with a coarse fit, at most `each` of one effect, twice as many as are fitted in
/// full: what options bring shows only when they are there.
std::vector<int> BestOfEach(const std::vector<FullTrial>& trials, int channels,
                            const TrialOptions& options) {
  std::vector<int> chosen;
  for (int i = 0; i < static_cast<int>(trials.size()); ++i) {
    if (!trials[i].coarse.ok || static_cast<int>(chosen.size()) >= 2 * options.full_fits) continue;
    if (MeanLogSquare(trials[i].coarse.residual, channels) > options.most_coarse) continue;
    const std::string& effect = trials[i].candidate->effect;
    const auto same = std::count_if(chosen.begin(), chosen.end(),
                                    [&](int k) { return trials[k].candidate->effect == effect; });
    if (same < options.each) chosen.push_back(i);
  }
  return chosen;
}

/// True if both say the same with the same free numbers, whatever the way to them.
bool AreSame(const Candidate& a, const Candidate& b) {
  if (a.effect != b.effect || a.params.targets != b.params.targets) return false;
  const auto numbers = [](const Candidate& c) {
    std::map<std::string, double> out = c.params.values;
    for (const FreeParameter& p : c.free) {
      out[p.name.substr(p.name.rfind('.') + 1)] = std::numeric_limits<double>::infinity();
    }
    return out;
  };
  return numbers(a) == numbers(b);
}

/// Of trials that have come to the same form the best on the coarse record.
std::vector<int> Distinct(const std::vector<FullTrial>& trials, const std::vector<int>& chosen) {
  std::vector<int> out;
  for (const int k : chosen) {
    const auto same = std::find_if(out.begin(), out.end(), [&](int other) {
      return AreSame(trials[k].form, trials[other].form);
    });
    if (same == out.end()) {
      out.push_back(k);
    } else if (trials[k].coarse.residual.squaredNorm() <
               trials[*same].coarse.residual.squaredNorm()) {
      *same = k;
    }
  }
  return out;
}

/// Those of the shaped trials that are worth a full fit, the best on the coarse record first.
std::vector<int> MostPromising(const std::vector<FullTrial>& trials, std::vector<int> shaped,
                               int channels, int full_fits) {
  constexpr double kHopeless = 0.7;  // ln of the mean square behind the best
  const auto left = [&](int k) { return MeanLogSquare(trials[k].coarse.residual, channels); };
  std::stable_sort(shaped.begin(), shaped.end(), [&](int a, int b) { return left(a) < left(b); });
  if (shaped.empty()) return shaped;
  const double most = left(shaped.front()) + kHopeless;
  std::erase_if(shaped, [&](int k) { return left(k) > most; });
  if (static_cast<int>(shaped.size()) > full_fits) shaped.resize(static_cast<size_t>(full_fits));
  return shaped;
}

/// Where the full fit of a candidate begins: the numbers of its coarse fit. A thinned record may
/// mislead (a line that rings faster than its samples seems damped): where these say less than
/// nothing on the full one, what is best there of neighbours of each number and of the candidate's
/// own starts.
std::vector<double> FullStart(const FitProblem& problem, const FreeModel& whole,
                              const FitResult& without, const FullTrial& trial) {
  const std::vector<double>& coarse = trial.coarse.values;
  auto error = [&](const std::vector<double>& values) {
    const Eigen::VectorXd residual = problem.Residual(whole, values);
    return residual.size() > 0 ? residual.squaredNorm() : 1e300;
  };
  double least = error(coarse);
  if (least < without.residual.squaredNorm()) return coarse;
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
    const double here = error(values);
    if (here < least) least = here, best = std::move(values);
  }
  return best;
}

}  // namespace

std::vector<FullTrial> TryEffects(const FitProblem& problem, const FitProblem& coarse,
                                  const FreeModel& model, const FitResult& fit,
                                  const std::vector<Candidate>& list, const TrialOptions& options,
                                  const std::function<bool(double)>& tick, double* reference) {
  ScreeningOptions screening{options.coarse_fits, options.thorough};
  std::vector<std::vector<double>> points = options.points;
  if (points.empty()) points = Points(coarse, model, fit, options);
  if (!options.points.empty() ||
      (screening.thorough && AddDeclaredPoint(model, options.declared, &points))) {
    screening.hydraulic_from = std::max<size_t>(1, points.size() - 1);
  }
  std::vector<Trial> found = ScreenCandidates(
      coarse, model, points, list, screening, [&](double part) { return tick(0.15 * part); },
      reference);
  std::vector<FullTrial> trials;
  for (Trial& trial : found) {
    const Candidate form = *trial.candidate;
    trials.push_back({std::move(trial), form, {}});
  }
  const std::vector<int> chosen = BestOfEach(trials, problem.num_channels(), options);
  std::atomic<int> done{0};
  const auto part = [&](size_t of) { return 0.075 * done++ / static_cast<double>(of); };
  problem.ForEach(static_cast<int>(chosen.size()), [&](int k) {
    if (!tick(0.15 + part(chosen.size()))) return;
    FullTrial& trial = trials[chosen[k]];
    trial.coarse = ShapeForm(coarse, model, trial.coarse, &trial.form);
  });
  const std::vector<int> apart =
      MostPromising(trials, Distinct(trials, chosen), problem.num_channels(), options.full_fits);
  done = 0;
  problem.ForEach(static_cast<int>(apart.size()), [&](int k) {
    if (!tick(0.225 + part(apart.size()))) return;
    FullTrial& trial = trials[apart[k]];
    const FreeModel whole = WithCandidate(model, trial.form);
    trial.fit = FitNear(problem, whole, FullStart(problem, whole, fit, trial), {},
                        {.first_own = 0, .max_steps = 1});
    if (!trial.fit.ok) return;
    if (MeanLogSquare(trial.fit.residual, problem.num_channels()) > options.most_full) {
      trial.fit.ok = false;
      return;
    }
    const int count = static_cast<int>(trial.fit.values.size());
    trial.fit = FitBalanced(problem, whole, trial.fit.values, trial.fit.jacobian,
                            {.first_own = count, .max_steps = 6, .final_jacobian = true});
  });
  return trials;
}

void ShapeOnWhole(const FitProblem& problem, const FreeModel& model, FullTrial* trial) {
  Candidate form = trial->form;
  const FitResult shaped = AddOptions(problem, model, trial->fit, &form);
  if (form.free.size() == trial->form.free.size()) return;
  const FreeModel whole = WithCandidate(model, form);
  FitResult fit = FitBalanced(problem, whole, shaped.values, shaped.jacobian,
                              {.first_own = static_cast<int>(shaped.values.size()),
                               .max_steps = 6,
                               .final_jacobian = true});
  if (fit.ok) trial->form = std::move(form), trial->fit = std::move(fit);
}

double MostOfRivals(const FitProblem& coarse, const FreeModel& model,
                    const std::vector<double>& values) {
  constexpr double kShaping = 0.6;
  const Eigen::VectorXd now = coarse.Residual(model, values);
  return now.size() > 0 ? MeanLogSquare(now, coarse.num_channels()) + kShaping : 1e300;
}

}  // namespace phs::identify::search
