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

/// Points from here on lie away from the best fit: an effect changes there what the model's own
/// numbers do.
constexpr size_t kElsewhere = 1;
constexpr double kReach = 0.8;  // [ln] how far one predicted step of a logarithmic number may go

/// Notes residual and values if they are the best of this candidate so far.
void Keep(const Eigen::VectorXd& residual, int channels, size_t point,
          const std::vector<double>& values, Trial* best) {
  best->predicted = std::min(best->predicted, MeanLogSquare(residual, channels));
  if (residual.squaredNorm() >= best->square) return;
  best->square = residual.squaredNorm();
  best->start = values;
  best->point = point;
}

/// One start of a candidate on one point, after one Gauss–Newton step.
struct Probe {
  size_t point = 0, start = 0;
  std::vector<double> values;
  double square = 1e300;
  bool acts = false;  ///< the effect's own numbers change something there
};

/// Tries one start of a candidate on top of one point by one step of all numbers: with the residual
/// as predicted or, `really`, as the model gives it there. `afresh`: the model's own columns too,
/// where the effect changes what its numbers do.
Probe ProbeStart(const Linear& at, size_t point, const FreeModel& model,
                 const std::vector<double>& values, bool really, bool afresh, Trial* best) {
  const int base = afresh ? 0 : static_cast<int>(at.model.free.size());
  Probe probe{.point = point, .values = values};
  Eigen::VectorXd r;
  Eigen::MatrixXd own;
  if (!at.problem.Linearise(model, values, base, &r, &own)) return probe;
  Eigen::MatrixXd j(r.size(), base + own.cols());
  j << at.jacobian.leftCols(base), own;
  const Eigen::VectorXd step = BoundedStep(model, values, r, j, 1e-6, kReach);
  for (size_t i = 0; i < probe.values.size(); ++i) {
    const FreeParameter& p = model.free[i];
    const double by = step[static_cast<Eigen::Index>(i)];
    if (by != 0) probe.values[i] = p.FromCoordinate(p.ToCoordinate(values[i]) + by);
  }
  const Eigen::VectorXd after =
      really ? at.problem.Residual(model, probe.values) : Eigen::VectorXd(r + j * step);
  if (after.size() == 0) return probe;
  constexpr double kNothing = 1e-6;
  const auto numbers = static_cast<Eigen::Index>(model.free.size() - at.model.free.size());
  probe.acts = own.rightCols(numbers).norm() > kNothing * r.norm();
  probe.square = after.squaredNorm();
  Keep(after, at.problem.num_channels(), point, probe.values, best);
  return probe;
}

/// Short fits from the best probes of different starts: for effects whose onset makes one step a
/// poor guide. Where the effect does nothing there is no way to where it does.
void FitProbes(const std::vector<Linear>& linear, const FreeModel& model, std::vector<Probe> probes,
               size_t afresh_from, Trial* best) {
  constexpr size_t kFits = 2;
  std::erase_if(probes, [](const Probe& p) { return !p.acts; });
  std::stable_sort(probes.begin(), probes.end(),
                   [](const Probe& a, const Probe& b) { return a.square < b.square; });
  std::vector<size_t> tried;
  for (size_t i = 0; i < probes.size() && tried.size() < kFits; ++i) {
    if (std::find(tried.begin(), tried.end(), probes[i].start) != tried.end()) continue;
    tried.push_back(probes[i].start);
    const Linear& at = linear[probes[i].point];
    const bool afresh = probes[i].point >= afresh_from;
    const int base = static_cast<int>(at.model.free.size());
    const FitResult fit =
        FitNear(at.problem, model, probes[i].values, at.jacobian,
                {.first_own = afresh ? 0 : base, .max_steps = afresh ? 8 : 4, .tolerance = 1e-3});
    if (fit.ok) {
      Keep(fit.residual, at.problem.num_channels(), probes[i].point, fit.values, best);
    }
  }
}

void Screen(const std::vector<Linear>& linear, const Candidate& candidate,
            const ScreeningOptions& options, Trial* best) {
  best->candidate = &candidate;
  const bool thorough = options.thorough && candidate.has_onset;
  const FreeModel model = WithCandidate(linear.front().model, candidate);
  std::vector<Probe> probes;
  for (size_t k = 0; k < linear.size(); ++k) {
    if (k >= options.hydraulic_from && !candidate.hydraulic) continue;
    for (size_t i = 0; i < candidate.starts.size(); ++i) {
      const std::vector<double>& start = candidate.starts[i];
      std::vector<double> values = linear[k].values;
      values.insert(values.end(), start.begin(), start.end());
      const bool afresh = thorough && k >= kElsewhere;
      probes.push_back(ProbeStart(linear[k], k, model, values, thorough, afresh, best));
      probes.back().start = i;
    }
  }
  if (thorough) FitProbes(linear, model, std::move(probes), kElsewhere, best);
}

/// In turn the best by mean log square and the best by sum of squares: a rare
/// strong deviation (a stop, a blow-off) shows in the second only. At most two
/// variants of one effect in front.
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

/// Fits a trial on the coarse record from where it promises most. Where that falls far short of the
/// promise (a number beside which there is no way back, as an onset), from the candidate's own
/// starts too.
FitResult FitTrial(const FitProblem& coarse, const FreeModel& model, const Linear& at,
                   const Trial& trial) {
  constexpr double kShort = 0.15;  // ln of the mean square
  const FreeModel whole = WithCandidate(model, *trial.candidate);
  const auto fit = [&](const std::vector<double>& start) {
    return FitNear(coarse, whole, start, at.jacobian,
                   {.first_own = static_cast<int>(model.free.size()), .max_steps = 8});
  };
  FitResult best = fit(trial.start);
  if (!best.ok) return best;
  const int channels = coarse.num_channels();
  if (MeanLogSquare(best.residual, channels) < trial.predicted + kShort) return best;
  for (const std::vector<double>& own : trial.candidate->starts) {
    std::vector<double> start = at.values;
    start.insert(start.end(), own.begin(), own.end());
    FitResult other = fit(start);
    if (other.ok && other.residual.squaredNorm() < best.residual.squaredNorm()) {
      best = std::move(other);
    }
  }
  return best;
}

}  // namespace

std::vector<Trial> ScreenCandidates(const FitProblem& coarse, const FreeModel& model,
                                    const std::vector<std::vector<double>>& points,
                                    const std::vector<Candidate>& list,
                                    const ScreeningOptions& options,
                                    const std::function<bool(double)>& tick, double* reference) {
  std::vector<Linear> linear;
  for (const std::vector<double>& point : points) {
    Linear at{coarse, model, point, {}, {}};
    if (coarse.Linearise(model, point, 0, &at.residual, &at.jacobian)) {
      linear.push_back(std::move(at));
    }
  }
  if (linear.empty()) return {};
  const Linear& first = linear.front();
  const Eigen::VectorXd alone =
      BoundedStep(model, first.values, first.residual, first.jacobian, 1e-6, kReach);
  *reference = MeanLogSquare(first.residual + first.jacobian * alone, coarse.num_channels());
  std::vector<Trial> trials(list.size());
  std::atomic<int> done{0};
  coarse.ForEach(static_cast<int>(list.size()), [&](int i) {
    if (!tick(0.6 * done++ / static_cast<double>(list.size()))) return;
    Screen(linear, list[i], options, &trials[i]);
  });
  std::erase_if(trials, [](const Trial& t) { return t.candidate == nullptr || t.start.empty(); });
  SortByPromise(&trials);
  const int fits = std::min(options.coarse_fits, static_cast<int>(trials.size()));
  done = 0;
  coarse.ForEach(fits, [&](int i) {
    if (!tick(0.6 + 0.4 * done++ / fits)) return;
    Trial& t = trials[i];
    t.coarse = FitTrial(coarse, model, linear[t.point], t);
    if (t.coarse.ok) t.coarse_score = CoarseScore(coarse, t.coarse);
  });
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.coarse_score < b.coarse_score; });
  return trials;
}

}  // namespace phs::identify::search
