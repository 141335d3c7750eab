#include "identify/select/screening.h"

#include <Eigen/QR>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "identify/fit/evidence.h"
#include "identify/fit/near_fit.h"

namespace phs::identify::search {
namespace {

constexpr double kReach = 0.8;  // [ln] how far one predicted step of a logarithmic number may go

/// One start of a candidate about one point.
struct Probe {
  size_t point = 0;
  std::vector<double> values;  ///< of all numbers
  double score = 1e300;        ///< -2 ln L
};

/// Of each start the best by what a step promises; the best of all as they stand, and the best by
/// what a step promises once the amounts are moved (Scale).
struct Probes {
  std::vector<Probe> promised;  ///< best first
  Probe present, moved;
  /// Of a single start and point: a step that keeps its promise has begun there.
  bool one = false;
};

void Keep(double score, size_t point, const std::vector<double>& values, Probe* best) {
  if (score < best->score) *best = {point, values, score};
}

/// A point and what all its probes share.
struct Base {
  const Point* at = nullptr;
  Eigen::VectorXd coefficients;  ///< of its residual
  Eigen::VectorXd weight;
  Eigen::MatrixXd weighted;  ///< its slopes
  Eigen::MatrixXd basis;     ///< of these, orthonormal
};

std::vector<double> ValuesAt(const Base& base, const std::vector<double>& start) {
  std::vector<double> values = base.at->values;
  values.insert(values.end(), start.begin(), start.end());
  return values;
}

/// What one step from a start about a point promises. `own`: slopes of the candidate's numbers.
void Promise(const FitProblem& problem, const FreeModel& model, const Base& base, size_t point,
             const std::vector<double>& values, const Eigen::VectorXd& coefficients,
             const Eigen::MatrixXd& own, Probe* promised) {
  const Likelihood& likelihood = problem.likelihood();
  const Eigen::MatrixXd& known = base.at->slopes;
  Eigen::MatrixXd slopes(likelihood.size(), known.cols() + own.cols());
  slopes << base.weighted, base.weight.asDiagonal() * own;
  const Eigen::VectorXd step =
      BoundedStep(model, values, base.weight.cwiseProduct(coefficients), slopes, 1e-6, kReach);
  const Eigen::VectorXd then =
      coefficients + known * step.head(known.cols()) + own * step.tail(own.cols());
  Keep(likelihood.MinusTwoLog(likelihood.Powers(then)), point, Moved(model, values, step),
       promised);
}

/// Where the amounts of a start should be, by what it does and how that follows from them, both as
/// coefficients about the best fit.
struct Scaled {
  double way = 0;    ///< [ln] of the amounts
  double share = 1;  ///< of what the start does
};

/// An effect acts as some power p of its amounts, d(does)/d(ln amount) = p does, whatever else is
/// there. The share of what it does that is best about a point, beside the point's own numbers,
/// tells how far off the amounts are: ln(share)/p. Within a step's reach it is left to the step.
Scaled Scale(const Base& base, const Candidate& candidate, const Eigen::VectorXd& does,
             const Eigen::MatrixXd& own) {
  constexpr double kLeastPower = 0.25, kMost = 300;
  for (int k = 0; k < candidate.mains; ++k) {
    const auto i = static_cast<size_t>(k);
    if (!candidate.free[i].logarithmic || candidate.none[i] > 0) return {};
  }
  const auto beside = [&](const Eigen::VectorXd& v) -> Eigen::VectorXd {
    const Eigen::VectorXd weighted = base.weight.cwiseProduct(v);
    return weighted - base.basis * (base.basis.transpose() * weighted);
  };
  const Eigen::VectorXd shown = beside(does), left = beside(base.coefficients);
  const double square = shown.squaredNorm();
  if (!(square > 0)) return {};
  const double power = does.dot(own.leftCols(candidate.mains).rowwise().sum()) / does.squaredNorm();
  const double share = std::clamp(-shown.dot(left) / square, 1 / kMost, kMost);
  const double way = std::log(share) / std::copysign(std::max(kLeastPower, std::abs(power)), power);
  return std::abs(way) > kReach ? Scaled{way, share} : Scaled{};
}

/// What a start does to the coefficients, and the slopes of the candidate's numbers, about the first
/// point; as known from an earlier round, if it is.
struct Answer {
  Eigen::VectorXd does;
  Eigen::MatrixXd own;
};

std::optional<Answer> AnswerOf(const FitProblem& problem, const FreeModel& whole, const Base& base,
                               const Candidate& candidate, size_t start, KnownAnswers* known) {
  const Likelihood& likelihood = problem.likelihood();
  const KnownAnswer* before = known != nullptr ? known->Find(candidate, start) : nullptr;
  const Eigen::VectorXd weight = known != nullptr ? problem.WeightOfRows() : Eigen::VectorXd();
  if (before != nullptr) {
    return Answer{
        likelihood.Transform(Eigen::VectorXd(weight.cwiseProduct(before->does.cast<double>()))),
        likelihood.Transform(Eigen::MatrixXd(weight.asDiagonal() * before->own.cast<double>()))};
  }
  Eigen::VectorXd residual;
  Eigen::MatrixXd own;
  const std::vector<double> values = ValuesAt(base, candidate.starts[start]);
  if (!problem.Linearise(whole, values, static_cast<int>(base.at->values.size()), &residual, &own))
    return std::nullopt;
  const Eigen::VectorXd does = residual - base.at->residual;
  if (known != nullptr) {
    const Eigen::VectorXd over =
        (weight.array() > 0).select(weight.cwiseMax(1e-300).cwiseInverse(), 0);
    known->Keep(candidate, start,
                {over.cwiseProduct(does).cast<float>(),
                 Eigen::MatrixXd(over.asDiagonal() * own).cast<float>()});
  }
  return Answer{likelihood.Transform(does), likelihood.Transform(own)};
}

/// Every start about every point. What a start does, and the slopes of the candidate's numbers, are
/// those about the first point, the best fit: they differ little from point to point, and cost
/// runs.
Probes Probed(const FitProblem& problem, const FreeModel& model, const std::vector<Base>& bases,
              const Candidate& candidate, KnownAnswers* known) {
  const FreeModel whole = WithCandidate(model, candidate);
  const size_t first = bases[0].at->values.size();
  const Likelihood& likelihood = problem.likelihood();
  Probes best;
  best.one = candidate.starts.size() * bases.size() == 1;
  for (size_t s = 0; s < candidate.starts.size(); ++s) {
    const std::vector<double>& start = candidate.starts[s];
    const auto answer = AnswerOf(problem, whole, bases[0], candidate, s, known);
    if (!answer) continue;
    const auto& [does, own] = *answer;
    Probe promised;
    for (size_t k = 0; k < bases.size(); ++k) {
      std::vector<double> values = ValuesAt(bases[k], start);
      const Eigen::VectorXd there = bases[k].coefficients + does;
      Keep(likelihood.MinusTwoLog(likelihood.Powers(there)), k, values, &best.present);
      Promise(problem, whole, bases[k], k, values, there, own, &promised);
      const Scaled scaled = Scale(bases[k], candidate, does, own);
      if (scaled.way == 0) continue;
      for (size_t i = first; i < first + static_cast<size_t>(candidate.mains); ++i) {
        const FreeParameter& p = whole.free[i];
        values[i] = p.FromCoordinate(p.ToCoordinate(values[i]) + scaled.way);
      }
      Promise(problem, whole, bases[k], k, values, bases[k].coefficients + scaled.share * does,
              scaled.share * own, &best.moved);
    }
    if (!promised.values.empty()) best.promised.push_back(std::move(promised));
  }
  std::stable_sort(best.promised.begin(), best.promised.end(),
                   [](const Probe& a, const Probe& b) { return a.score < b.score; });
  return best;
}

/// Steps really taken from each of the best starts, and from where they led best. A law that begins at
/// a value (a diaphragm's stop) says less than none at first, for two or three steps from most starts.
Trial TakeSteps(const FitProblem& problem, const FreeModel& model, const std::vector<Point>& points,
                const Candidate& candidate, const Probes& best, const Effort& effort) {
  Trial trial;
  trial.candidate = &candidate;
  const FreeModel whole = WithCandidate(model, candidate);
  std::vector<Probe> probes = best.promised;
  const auto starts = static_cast<size_t>(effort.starts);
  if (probes.size() > starts) probes.resize(starts);
  probes.push_back(best.moved), probes.push_back(best.present);
  const NearFitOptions few{.first_own = static_cast<int>(points[0].values.size()),
                           .max_steps = effort.steps,
                           .enough = Criterion(problem, 0, 1),
                           .intervals = false};
  for (const Probe& probe : probes) {
    if (probe.values.empty()) continue;
    const bool as_it_stands = &probe == &probes.back();
    if (as_it_stands && best.one && trial.coarse.ok && trial.coarse.score < best.present.score)
      break;
    FitResult fit = FitNear(problem, whole, probe.values, points[probe.point].slopes, few);
    if (fit.ok && (!trial.coarse.ok || fit.score < trial.coarse.score))
      trial.coarse = std::move(fit);
  }
  if (!trial.coarse.ok) return trial;
  FitResult on = FitNear(problem, whole, trial.coarse.values, trial.coarse.slopes, few);
  if (on.ok && on.score < trial.coarse.score) trial.coarse = std::move(on);
  trial.promise = Criterion(problem, trial.coarse.score, trial.coarse.values.size());
  return trial;
}

/// What it promises at best: -2 ln L.
double BestOf(const Probes& p) {
  const double stepped = p.promised.empty() ? 1e300 : p.promised.front().score;
  return std::min({stepped, p.present.score, p.moved.score});
}

/// Those that promise most, stand best, or promise most once moved, in turn. `least`: -2 ln L that
/// each must promise at least, so that it pays for its own numbers.
std::vector<size_t> MostPromising(const std::vector<Probes>& probes,
                                  const std::vector<double>& least, int most) {
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
  const auto moved = ranked([](const Probes& p) { return p.moved.score; });
  std::vector<size_t> out;
  for (size_t i = 0; i < probes.size() && static_cast<int>(out.size()) < most; ++i) {
    for (const size_t k : {promised[i], present[i], moved[i]}) {
      if (probes[k].promised.empty() || !(BestOf(probes[k]) < least[k])) continue;
      if (std::find(out.begin(), out.end(), k) == out.end()) out.push_back(k);
    }
  }
  return out;
}

/// -2 ln L at which each candidate would just pay for its own numbers.
std::vector<double> PaidFor(const FitProblem& coarse, const Point& point,
                            const std::vector<Candidate>& list, const Effort& effort) {
  if (effort.unpromising) return std::vector<double>(list.size(), 1e300);
  std::vector<double> least;
  least.reserve(list.size());
  for (const Candidate& candidate : list) {
    least.push_back(point.score - Criterion(coarse, 0, candidate.free.size()));
  }
  return least;
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
                                    const std::function<bool(double)>& go_on, KnownAnswers* known) {
  constexpr double kProbes = 0.4, kShare = 0.6;  // of the work
  std::vector<Probes> probes(list.size());
  std::vector<Base> bases;
  for (const Point& point : points) {
    const Eigen::VectorXd weight = coarse.likelihood().Weights(point.powers);
    const Eigen::MatrixXd weighted = weight.asDiagonal() * point.slopes;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(weighted);
    bases.push_back(
        {&point, coarse.likelihood().Transform(point.residual), weight, weighted,
         qr.householderQ() * Eigen::MatrixXd::Identity(weighted.rows(), weighted.cols())});
  }
  std::atomic<int> done{0};
  coarse.ForEach(static_cast<int>(list.size()), [&](int i) {
    if (!go_on(kProbes * done++ / static_cast<double>(list.size()))) return;
    const auto k = static_cast<size_t>(i);
    probes[k] = Probed(coarse, model, bases, list[k], known);
  });
  if (known != nullptr) known->EndRound();
  const std::vector<size_t> tried =
      MostPromising(probes, PaidFor(coarse, points.front(), list, effort), effort.stepped);
  std::vector<Trial> trials(tried.size());
  done = 0;
  coarse.ForEach(static_cast<int>(tried.size()), [&](int i) {
    if (!go_on(kProbes + (kShare - kProbes) * done++ / static_cast<double>(tried.size()))) return;
    const size_t k = tried[static_cast<size_t>(i)];
    trials[static_cast<size_t>(i)] = TakeSteps(coarse, model, points, list[k], probes[k], effort);
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
  for (size_t k = 0; k < list.size(); ++k) {
    if (BestOf(probes[k]) < Probe{}.score) continue;
    trials.emplace_back();
    trials.back().candidate = &list[k], trials.back().fails = true;
  }
  return trials;
}

}  // namespace phs::identify::search
