#include "identify/screening.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <numeric>

#include "identify/evidence.h"
#include "identify/near_fit.h"

namespace phs::identify::search {
namespace {

constexpr double kReach = 0.8;  // [ln] how far one predicted step of a logarithmic number may go

/// One start of a candidate about one point.
struct Probe {
  size_t point = 0;
  std::vector<double> values;  ///< of all numbers
  double score = 1e300;        ///< -2 ln L
};

/// Of each start the best by what a step promises, and the best of all as they stand.
struct Probes {
  std::vector<Probe> promised;  ///< best first
  Probe present;
  /// Of a single start and point: a step that keeps its promise has begun there.
  bool one = false;
};

void Keep(double score, size_t point, const std::vector<double>& values, Probe* best) {
  if (score < best->score) *best = {point, values, score};
}

/// A point and what all its probes share.
struct Base {
  const Point* at = nullptr;
  Eigen::VectorXd weight;
  Eigen::MatrixXd weighted;  ///< its slopes
};

std::vector<double> ValuesAt(const Base& base, const std::vector<double>& start) {
  std::vector<double> values = base.at->values;
  values.insert(values.end(), start.begin(), start.end());
  return values;
}

/// Score of a start about a point, and what one step from there promises. `own`: slopes of the
/// candidate's numbers.
void Promise(const FitProblem& problem, const FreeModel& model, const Base& base, size_t point,
             const std::vector<double>& values, const Eigen::VectorXd& coefficients,
             const Eigen::MatrixXd& own, Probe* promised, Probe* present) {
  const Likelihood& likelihood = problem.likelihood();
  const Eigen::MatrixXd& known = base.at->slopes;
  Eigen::MatrixXd slopes(likelihood.size(), known.cols() + own.cols());
  slopes << base.weighted, base.weight.asDiagonal() * own;
  const Eigen::VectorXd step =
      BoundedStep(model, values, base.weight.cwiseProduct(coefficients), slopes, 1e-6, kReach);
  const Eigen::VectorXd then =
      coefficients + known * step.head(known.cols()) + own * step.tail(own.cols());
  Keep(likelihood.MinusTwoLog(likelihood.Powers(coefficients)), point, values, present);
  Keep(likelihood.MinusTwoLog(likelihood.Powers(then)), point, Moved(model, values, step),
       promised);
}

/// Slopes of the candidate's numbers about `values`, whose residual is known. An amount acts in
/// proportion to itself, so the slope of the first is what all of them do, r - r(none), less what
/// the others do: no run of its own. Empty where the model refuses.
Eigen::MatrixXd OwnSlopes(const FitProblem& problem, const FreeModel& whole,
                          const Candidate& candidate, const Base& base,
                          const std::vector<double>& values, const Eigen::VectorXd& residual) {
  const size_t first = base.at->values.size();
  const auto way = [&](size_t k) {  // of an amount in its coordinate, from where it does nothing
    const FreeParameter& p = candidate.free[k];
    if (p.logarithmic && candidate.none[k] <= 0) return 1.0;
    return p.ToCoordinate(values[first + k]) - p.ToCoordinate(candidate.none[k]);
  };
  Eigen::MatrixXd others;
  if (way(0) == 0 || candidate.mains < 1) {
    if (!problem.CalcSlopes(whole, values, static_cast<int>(first), residual, &others)) return {};
    return others;
  }
  if (!problem.CalcSlopes(whole, values, static_cast<int>(first) + 1, residual, &others)) return {};
  Eigen::VectorXd done = residual - base.at->residual;
  for (int k = 1; k < candidate.mains; ++k) {
    done -= way(static_cast<size_t>(k)) * others.col(k - 1);
  }
  Eigen::MatrixXd own(residual.size(), others.cols() + 1);
  own << done / way(0), others;
  return own;
}

/// Every start about every point, with the slopes of the candidate's numbers about the first, the
/// best fit: they differ little from point to point, and cost most.
Probes Probed(const FitProblem& problem, const FreeModel& model, const std::vector<Base>& bases,
              const Candidate& candidate) {
  const FreeModel whole = WithCandidate(model, candidate);
  const Likelihood& likelihood = problem.likelihood();
  Probes best;
  best.one = candidate.starts.size() * bases.size() == 1;
  for (const std::vector<double>& start : candidate.starts) {
    std::vector<double> values = ValuesAt(bases[0], start);
    Eigen::VectorXd residual = problem.Residual(whole, values);
    if (residual.size() == 0) continue;
    Eigen::MatrixXd own = OwnSlopes(problem, whole, candidate, bases[0], values, residual);
    if (own.size() == 0) continue;
    own = likelihood.Transform(own);
    Probe promised;
    for (size_t k = 0; k < bases.size(); ++k) {
      if (k > 0) values = ValuesAt(bases[k], start), residual = problem.Residual(whole, values);
      if (residual.size() == 0) continue;
      Promise(problem, whole, bases[k], k, values, likelihood.Transform(residual), own, &promised,
              &best.present);
    }
    if (!promised.values.empty()) best.promised.push_back(std::move(promised));
  }
  std::stable_sort(best.promised.begin(), best.promised.end(),
                   [](const Probe& a, const Probe& b) { return a.score < b.score; });
  return best;
}

/// Some steps really taken from the best starts.
Trial TakeSteps(const FitProblem& problem, const FreeModel& model, const std::vector<Point>& points,
                const Candidate& candidate, const Probes& best, size_t starts) {
  Trial trial;
  trial.candidate = &candidate;
  const FreeModel whole = WithCandidate(model, candidate);
  std::vector<Probe> probes = best.promised;
  if (probes.size() > starts) probes.resize(starts);
  probes.push_back(best.present);
  for (const Probe& probe : probes) {
    if (probe.values.empty()) continue;
    if (best.one && trial.coarse.ok && trial.coarse.score < best.present.score) continue;
    const Point& at = points[probe.point];
    FitResult fit = FitNear(problem, whole, probe.values, at.slopes,
                            {.first_own = static_cast<int>(at.values.size()), .max_steps = 4});
    if (!fit.ok) continue;
    const double criterion = Criterion(problem, fit.score, fit.values.size());
    if (criterion < trial.promise) trial.promise = criterion, trial.coarse = std::move(fit);
  }
  return trial;
}

/// Those that promise most or stand best, in turn.
std::vector<size_t> MostPromising(const std::vector<Probes>& probes, int most) {
  const auto ranked = [&](auto score) {
    std::vector<size_t> order(probes.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return score(probes[a]) < score(probes[b]); });
    return order;
  };
  const auto promised =
      ranked([](const Probes& p) { return p.promised.empty() ? 1e300 : p.promised.front().score; });
  const auto present = ranked([](const Probes& p) { return p.present.score; });
  std::vector<size_t> out;
  for (size_t i = 0; i < probes.size() && static_cast<int>(out.size()) < most; ++i) {
    for (const size_t k : {promised[i], present[i]}) {
      if (probes[k].promised.empty()) continue;
      if (std::find(out.begin(), out.end(), k) == out.end()) out.push_back(k);
    }
  }
  return out;
}

/// Best first, at most two variants of one effect in front.
void SortByPromise(std::vector<Trial>* trials) {
  constexpr int kOfOne = 2;
  std::stable_sort(trials->begin(), trials->end(),
                   [](const Trial& a, const Trial& b) { return a.promise < b.promise; });
  std::map<std::string, int> taken;
  std::vector<Trial> front, rest;
  for (Trial& trial : *trials) {
    (taken[trial.candidate->effect]++ < kOfOne ? front : rest).push_back(std::move(trial));
  }
  for (Trial& trial : rest) front.push_back(std::move(trial));
  *trials = std::move(front);
}

}  // namespace

std::vector<Trial> ScreenCandidates(const FitProblem& coarse, const FreeModel& model,
                                    const std::vector<Point>& points,
                                    const std::vector<Candidate>& list, const Effort& effort,
                                    const std::function<bool(double)>& go_on) {
  constexpr double kProbes = 0.4, kShare = 0.6;  // of the work
  std::vector<Probes> probes(list.size());
  std::vector<Base> bases;
  for (const Point& point : points) {
    const Eigen::VectorXd weight = coarse.likelihood().Weights(point.powers);
    bases.push_back({&point, weight, weight.asDiagonal() * point.slopes});
  }
  std::atomic<int> done{0};
  coarse.ForEach(static_cast<int>(list.size()), [&](int i) {
    if (!go_on(kProbes * done++ / static_cast<double>(list.size()))) return;
    const auto k = static_cast<size_t>(i);
    probes[k] = Probed(coarse, model, bases, list[k]);
  });
  const std::vector<size_t> tried = MostPromising(probes, 3 * effort.coarse_fits);
  std::vector<Trial> trials(tried.size());
  done = 0;
  coarse.ForEach(static_cast<int>(tried.size()), [&](int i) {
    if (!go_on(kProbes + (kShare - kProbes) * done++ / static_cast<double>(tried.size()))) return;
    const size_t k = tried[static_cast<size_t>(i)];
    trials[static_cast<size_t>(i)] =
        TakeSteps(coarse, model, points, list[k], probes[k], static_cast<size_t>(effort.starts));
  });
  std::erase_if(trials, [](const Trial& t) { return !t.coarse.ok; });
  SortByPromise(&trials);
  const size_t fits = std::min(static_cast<size_t>(effort.coarse_fits), trials.size());
  for (size_t i = fits; i < trials.size(); ++i) trials[i].coarse.ok = false;
  done = 0;
  coarse.ForEach(static_cast<int>(fits), [&](int i) {
    if (!go_on(kShare + (1 - kShare) * done++ / static_cast<double>(fits))) return;
    Trial& t = trials[static_cast<size_t>(i)];
    const FreeModel whole = WithCandidate(model, *t.candidate);
    t.coarse = FitBothWays(coarse, whole, t.coarse, static_cast<int>(model.free.size()));
    t.promise = Criterion(coarse, t.coarse.score, t.coarse.values.size());
  });
  std::stable_sort(trials.begin(), trials.begin() + static_cast<long>(fits),
                   [](const Trial& a, const Trial& b) { return a.promise < b.promise; });
  return trials;
}

}  // namespace phs::identify::search
