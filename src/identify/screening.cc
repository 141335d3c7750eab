#include "identify/screening.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "identify/evidence.h"
#include "identify/near_fit.h"

namespace phs::identify::search {
namespace {

/// The current model linearised once on the coarse record.
struct Linear {
  const FitProblem& problem;
  const FreeModel& model;
  const std::vector<double>& values;
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
};

constexpr double kReach = 0.8;  // [ln] how far one predicted step of a logarithmic number may go

/// Best start of one candidate by a predicted Gauss–Newton step.
Trial Screen(const Linear& at, const Candidate& candidate) {
  Trial best;
  best.candidate = &candidate;
  const FreeModel model = WithCandidate(at.model, candidate);
  const int base = static_cast<int>(at.model.free.size());
  const int count = static_cast<int>(model.free.size());
  for (const auto& start : candidate.starts) {
    std::vector<double> values = at.values;
    values.insert(values.end(), start.begin(), start.end());
    Eigen::VectorXd r;
    Eigen::MatrixXd own;
    if (!at.problem.Linearise(model, values, base, &r, &own)) continue;
    Eigen::MatrixXd j(r.size(), count);
    j << at.jacobian, own;
    const Eigen::VectorXd step = BoundedStep(model, values, r, j, 1e-6, kReach);
    const Eigen::VectorXd after = r + j * step;
    best.predicted = std::min(best.predicted, MeanLogSquare(after, at.problem.num_channels()));
    if (after.squaredNorm() >= best.square) continue;
    best.square = after.squaredNorm();
    best.start = values;
    for (int i = 0; i < count; ++i) {
      const FreeParameter& p = model.free[static_cast<size_t>(i)];
      double& value = best.start[static_cast<size_t>(i)];
      if (step[i] != 0) value = p.FromCoordinate(p.ToCoordinate(value) + step[i]);
    }
  }
  return best;
}

/// In turn the best by mean log square and the best by sum of squares: a rare strong deviation (a
/// stop, a blow-off) shows in the second only. At most two variants of one effect in front.
void SortByPromise(std::vector<Trial>* trials) {
  const size_t n = trials->size();
  std::vector<size_t> by_log(n), by_square(n), order;
  std::iota(by_log.begin(), by_log.end(), 0);
  std::iota(by_square.begin(), by_square.end(), 0);
  const std::vector<Trial>& t = *trials;
  std::stable_sort(by_log.begin(), by_log.end(),
                   [&](size_t a, size_t b) { return t[a].predicted < t[b].predicted; });
  std::stable_sort(by_square.begin(), by_square.end(),
                   [&](size_t a, size_t b) { return t[a].square < t[b].square; });
  std::vector<char> in(n, 0);
  for (size_t i = 0; i < n; ++i) {
    for (size_t k : {by_log[i], by_square[i]}) {
      if (!in[k]) order.push_back(k), in[k] = 1;
    }
  }
  std::vector<Trial> sorted, rest;
  std::vector<std::string> taken;
  for (size_t k : order) {
    Trial& trial = (*trials)[k];
    const auto same = std::count(taken.begin(), taken.end(), trial.candidate->effect);
    taken.push_back(trial.candidate->effect);
    (same < 2 ? sorted : rest).push_back(std::move(trial));
  }
  for (Trial& trial : rest) sorted.push_back(std::move(trial));
  *trials = std::move(sorted);
}

/// Information criterion of a coarse fit per coarse sample.
double CoarseScore(const FitProblem& problem, const FitResult& fit) {
  const double n = problem.samples() * problem.num_channels();
  return MeanLogSquare(fit.residual, problem.num_channels()) +
         static_cast<double>(fit.values.size()) * std::log(n) / (0.25 * n);
}

}  // namespace

std::vector<Trial> ScreenCandidates(const FitProblem& coarse, const FreeModel& model,
                                    const std::vector<double>& values,
                                    const std::vector<Candidate>& list,
                                    const ScreeningOptions& options,
                                    const std::function<bool(double)>& tick, double* reference) {
  Linear linear{coarse, model, values, {}, {}};
  std::vector<Trial> trials(list.size());
  if (!coarse.Linearise(model, values, 0, &linear.residual, &linear.jacobian)) return {};
  const Eigen::VectorXd alone =
      BoundedStep(model, values, linear.residual, linear.jacobian, 1e-6, kReach);
  *reference = MeanLogSquare(linear.residual + linear.jacobian * alone, coarse.num_channels());
  std::atomic<int> done{0};
  InParallel(static_cast<int>(list.size()), options.threads, [&](int i) {
    if (tick(0.6 * done++ / static_cast<double>(list.size()))) trials[i] = Screen(linear, list[i]);
  });
  std::erase_if(trials, [](const Trial& t) { return t.candidate == nullptr || t.start.empty(); });
  SortByPromise(&trials);
  const int fits = std::min(options.coarse_fits, static_cast<int>(trials.size()));
  done = 0;
  InParallel(fits, options.threads, [&](int i) {
    if (!tick(0.6 + 0.4 * done++ / fits)) return;
    Trial& t = trials[i];
    const FreeModel whole = WithCandidate(model, *t.candidate);
    t.coarse = FitNear(coarse, whole, t.start, linear.jacobian,
                       {.first_own = static_cast<int>(model.free.size()), .max_steps = 6});
    if (t.coarse.ok) t.coarse_score = CoarseScore(coarse, t.coarse);
  });
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.coarse_score < b.coarse_score; });
  return trials;
}

}  // namespace phs::identify::search
