#include "identify/effect_search.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>

namespace phs::identify::search {
namespace {

/// Residual mean square per channel on held-out blocks; the fit without them is one linear step.
double CrossValidatedLogVariance(const FitProblem& problem, const FitResult& fit,
                                 const std::vector<double>& independent) {
  constexpr int kBlocks = 6;
  const int n = problem.samples(), channels = problem.num_channels();
  const int k = static_cast<int>(fit.jacobian.cols());
  std::vector<Eigen::MatrixXd> normal(kBlocks, Eigen::MatrixXd::Zero(k, k));
  std::vector<Eigen::VectorXd> right(kBlocks, Eigen::VectorXd::Zero(k));
  auto segment = [&](int block, int* begin, int* count) {
    *begin = block * n / kBlocks, *count = (block + 1) * n / kBlocks - *begin;
  };
  for (int b = 0; b < kBlocks; ++b) {
    int begin, count;
    segment(b, &begin, &count);
    for (int c = 0; c < channels; ++c) {
      const auto j = fit.jacobian.middleRows(c * n + begin, count);
      const double w = 1 / std::max(1e-300, fit.channel_ms[c]);
      normal[b].noalias() += w * j.transpose() * j;
      right[b].noalias() += w * j.transpose() * fit.residual.segment(c * n + begin, count);
    }
  }
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(k, k);
  Eigen::VectorXd all_right = Eigen::VectorXd::Zero(k);
  for (int b = 0; b < kBlocks; ++b) all += normal[b], all_right += right[b];
  std::vector<double> held(channels, 0.0);
  for (int b = 0; b < kBlocks; ++b) {
    Eigen::MatrixXd rest = all - normal[b];
    rest.diagonal() += 1e-3 * all.diagonal() + Eigen::VectorXd::Constant(k, 1e-12);
    const Eigen::VectorXd step = rest.ldlt().solve(right[b] - all_right);
    int begin, count;
    segment(b, &begin, &count);
    for (int c = 0; c < channels; ++c) {
      held[c] += (fit.residual.segment(c * n + begin, count) +
                  fit.jacobian.middleRows(c * n + begin, count) * step)
                     .squaredNorm() /
                 n;
    }
  }
  double sum = 0, weight = 0;
  for (int c = 0; c < channels; ++c) {
    sum += independent[c] * std::log(std::max(1e-300, held[c]));
    weight += independent[c];
  }
  return sum / weight;
}

std::vector<double> IndependentSamples(const FitProblem& problem, const FitResult& fit) {
  std::vector<double> out;
  const int n = problem.samples();
  for (int c = 0; c < problem.num_channels(); ++c) {
    out.push_back(EffectiveSamples(fit.residual, c * n, n));
  }
  return out;
}

/// Sum of logs of the channels' mean squares: what BIC and ranking rest on.
double LogVariance(const FitResult& fit, const std::vector<double>& independent) {
  double sum = 0, weight = 0;
  for (size_t c = 0; c < fit.channel_ms.size(); ++c) {
    sum += independent[c] * std::log(std::max(1e-300, fit.channel_ms[c]));
    weight += independent[c];
  }
  return sum / weight;
}

std::string VariantName(const Candidate& candidate) {
  std::string name;
  for (const auto& t : candidate.params.targets) name += (name.empty() ? "" : ",") + t;
  for (const auto& p : candidate.free) {
    name += (name.empty() ? "" : ",") + p.name.substr(p.name.rfind('.') + 1);
  }
  return name;
}

struct Trial {
  const Candidate* candidate = nullptr;
  std::vector<double> start;  ///< of the candidate's own numbers, after the predicted step
  double score = 1e300;       ///< predicted mean log variance
  FitResult fit;
};

/// The current model linearised once for the screening of a round.
struct Linear {
  const FitProblem& problem;
  const FreeModel& model;
  const FitResult& fit;
};

/// Best start of one candidate by a predicted Gauss–Newton step.
Trial Screen(const Linear& at, const Candidate& candidate) {
  Trial best;
  best.candidate = &candidate;
  const FreeModel model = WithCandidate(at.model, candidate);
  const int base = static_cast<int>(at.model.free.size());
  const int count = static_cast<int>(model.free.size());
  const int n = at.problem.samples(), channels = at.problem.num_channels();
  const double equal = 1.0 / channels;
  for (const auto& start : candidate.starts) {
    std::vector<double> values = at.fit.values;
    values.insert(values.end(), start.begin(), start.end());
    Eigen::VectorXd r;
    Eigen::MatrixXd own;
    if (!at.problem.Linearise(model, values, base, &r, &own)) continue;
    Eigen::MatrixXd j(r.size(), count);
    j << at.fit.jacobian, own;
    Eigen::MatrixXd normal = j.transpose() * j;
    const Eigen::VectorXd damping = 1e-6 * normal.diagonal();
    normal.diagonal() += damping;
    normal.diagonal().array() += 1e-12 * normal.trace();
    const Eigen::VectorXd step = normal.ldlt().solve(-j.transpose() * r);
    Eigen::VectorXd bounded = step;
    for (int i = 0; i < count; ++i) {
      const FreeParameter& p = model.free[i];
      const double x = p.ToCoordinate(values[i]);
      const double reach = p.logarithmic ? 0.8 : 1e300;
      bounded[i] = std::clamp(step[i], std::max(-reach, p.ToCoordinate(p.low) - x),
                              std::min(reach, p.ToCoordinate(p.high) - x));
    }
    const Eigen::VectorXd after = r + j * bounded;
    double score = 0;
    for (int c = 0; c < channels; ++c) {
      score += equal * std::log(std::max(1e-300, after.segment(c * n, n).squaredNorm() / n));
    }
    if (score >= best.score) continue;
    best.score = score;
    best.start.clear();
    for (int i = 0; i < count; ++i) {
      const FreeParameter& p = model.free[i];
      best.start.push_back(p.FromCoordinate(p.ToCoordinate(values[i]) + bounded[i]));
    }
  }
  return best;
}

/// True if the main number of the candidate ended on a bound: not plausible, or not there.
bool OnBound(const FreeModel& model, const FitResult& fit, const Candidate& candidate) {
  const size_t base = model.free.size() - candidate.free.size();
  const FreeParameter& p = model.free[base];
  const double x = p.ToCoordinate(fit.values[base]), tiny = 1e-3;
  const double range = p.ToCoordinate(p.high) - p.ToCoordinate(p.low);
  return x - p.ToCoordinate(p.low) < tiny * range || p.ToCoordinate(p.high) - x < tiny * range;
}

class Search {
 public:
  Search(FitProblem* problem, const SearchOptions& options, const Progress& progress)
      : problem_(*problem), options_(options), progress_(progress) {}

  Result<Identification> Run(const hydraulics::PhsParams& declared) {
    out_.declared = DeclaredModel(declared);
    std::vector<double> start;
    for (const auto& p : out_.declared.free) start.push_back(p.start);
    out_.before = problem_.Fit(out_.declared, start, 15);
    if (out_.before.ok) {
      const Status s = problem_.SetWeights(problem_.Params(out_.declared, out_.before.values));
      if (!s.ok()) return s.error();
      out_.before = problem_.Fit(out_.declared, out_.before.values, 10);
    }
    if (!out_.before.ok) {
      return Error{declared.name, "the declared model could not be fitted",
                   "a model that can follow the measured motion", "check model and data"};
    }
    out_.corrected = out_.declared, out_.after = out_.before;
    for (int round = 0; round < options_.max_effects; ++round) {
      share_ = 0.02 + 0.9 * round / options_.max_effects;
      if (!AddOne(round)) break;
    }
    if (out_.effects.size() > 1) {
      Exchange();
      DropSuperfluous();
    }
    RankEffects();
    out_.cancelled = cancelled_;
    return std::move(out_);
  }

 private:
  bool Tick(double part) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!cancelled_ && progress_ && !progress_(std::min(1.0, share_ + part))) cancelled_ = true;
    return !cancelled_;
  }

  /// Screens and fits candidates on top of `model`; best first by BIC.
  std::vector<Trial> Try(const FreeModel& model, const FitResult& fit,
                         const std::vector<Candidate>& list, int full_fits) {
    const Linear linear{problem_, model, fit};
    std::vector<Trial> trials(list.size());
    std::atomic<int> done{0};
    InParallel(static_cast<int>(list.size()), options_.threads, [&](int i) {
      if (Tick(0.15 * done++ / list.size())) trials[i] = Screen(linear, list[i]);
    });
    std::erase_if(trials, [](const Trial& t) { return t.candidate == nullptr || t.start.empty(); });
    std::sort(trials.begin(), trials.end(),
              [](const Trial& a, const Trial& b) { return a.score < b.score; });
    std::vector<std::string> taken;  // at most two variants of one effect
    std::stable_partition(trials.begin(), trials.end(), [&](const Trial& t) {
      const long same = std::count(taken.begin(), taken.end(), t.candidate->effect);
      taken.push_back(t.candidate->effect);
      return same < 2;
    });
    const int fits = std::min(full_fits, static_cast<int>(trials.size()));
    done = 0;
    InParallel(fits, options_.threads, [&](int i) {
      if (!Tick(0.15 + 0.15 * done++ / fits)) return;
      trials[i].fit = problem_.Fit(WithCandidate(model, *trials[i].candidate), trials[i].start, 8);
    });
    return trials;
  }

  void Record(const std::vector<Trial>& trials, const FitResult& without, int round,
              std::vector<size_t>* places) {
    double start = 0;
    for (double ms : without.channel_ms) start += std::log(ms) / without.channel_ms.size();
    for (const Trial& trial : trials) {
      CandidateRecord record;
      record.effect = trial.candidate->effect;
      record.variant = VariantName(*trial.candidate);
      record.round = round + 1;
      record.screening_gain = 1 - std::exp(0.5 * (trial.score - start));
      record.fitted = trial.fit.ok;
      record.verdict = "screened out";
      if (trial.fit.ok) record.evidence = Compare(problem_, without, trial.fit);
      places->push_back(out_.candidates.size());
      out_.candidates.push_back(std::move(record));
    }
  }

  std::string Verdict(const Trial& trial, const Evidence& e, const FreeModel& model) const {
    if (e.delta_bic < options_.min_delta_bic) return "not significant";
    if (e.cross_validation_gain <= 0) return "no gain in cross-validation";
    if (e.estimation_gain < options_.min_gain && e.best_channel_gain < options_.min_channel_gain) {
      return "gain too small";
    }
    if (OnBound(model, trial.fit, *trial.candidate)) return "value not plausible";
    return "";
  }

  bool AddOne(int round) {
    const std::vector<Candidate> list = ListCandidates(out_.corrected.params, problem_.data().kind);
    std::vector<Trial> trials = Try(out_.corrected, out_.after, list, options_.full_fits);
    if (cancelled_) return false;
    std::vector<size_t> places;
    Record(trials, out_.after, round, &places);
    int best = -1;
    for (size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].fit.ok) continue;
      CandidateRecord& record = out_.candidates[places[i]];
      const FreeModel model = WithCandidate(out_.corrected, *trials[i].candidate);
      record.verdict = Verdict(trials[i], record.evidence, model);
      if (!record.verdict.empty()) continue;
      record.verdict = "another explains more";
      if (best < 0 ||
          record.evidence.delta_bic > out_.candidates[places[best]].evidence.delta_bic) {
        best = static_cast<int>(i);
      }
    }
    if (best < 0) return false;
    CandidateRecord& chosen = out_.candidates[places[best]];
    chosen.verdict = "accepted";
    AcceptedEffect accepted{*trials[best].candidate, chosen.evidence, {}};
    for (size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].fit.ok || trials[i].candidate->effect == chosen.effect) continue;
      NoteConfusable(trials[best].fit, trials[i], &accepted);
    }
    out_.corrected = WithCandidate(out_.corrected, *trials[best].candidate);
    out_.after = trials[best].fit;
    out_.effects.push_back(std::move(accepted));
    return true;
  }

  /// Others whose residual is within the margin and whose evidence is not far behind.
  void NoteConfusable(const FitResult& best, const Trial& other, AcceptedEffect* accepted) const {
    const Evidence e = Compare(problem_, other.fit, best);
    if (e.delta_bic > options_.min_delta_bic && e.estimation_gain > options_.margin) return;
    auto& names = accepted->confusable_with;
    if (std::find(names.begin(), names.end(), other.candidate->effect) == names.end()) {
      names.push_back(other.candidate->effect);
    }
  }

  /// The model of the accepted effects but one, fitted.
  FitResult Without(size_t dropped, FreeModel* model) const {
    *model = out_.declared;
    std::vector<double> start(out_.after.values.begin(),
                              out_.after.values.begin() + static_cast<long>(model->free.size()));
    size_t at = model->free.size();
    for (size_t i = 0; i < out_.effects.size(); ++i) {
      const Candidate& c = out_.effects[i].candidate;
      if (i != dropped) {
        *model = WithCandidate(*model, c);
        for (size_t k = 0; k < c.free.size(); ++k) start.push_back(out_.after.values[at + k]);
      }
      at += c.free.size();
    }
    return problem_.Fit(*model, start, 8);
  }

  /// Tries to replace each accepted effect but the last by another.
  void Exchange() {
    for (size_t i = 0; i + 1 < out_.effects.size() && !cancelled_; ++i) {
      share_ = 0.85;
      FreeModel model;
      const FitResult rest = Without(i, &model);
      if (!rest.ok) continue;
      std::vector<Candidate> list = ListCandidates(model.params, problem_.data().kind);
      const std::string old = out_.effects[i].candidate.effect;
      std::erase_if(list, [&](const Candidate& c) { return c.effect == old; });
      std::vector<Trial> trials = Try(model, rest, list, 3);
      for (Trial& trial : trials) {
        if (!trial.fit.ok) continue;
        const Evidence e = Compare(problem_, out_.after, trial.fit);
        const FreeModel whole = WithCandidate(model, *trial.candidate);
        if (e.delta_bic < options_.min_delta_bic || OnBound(whole, trial.fit, *trial.candidate)) {
          continue;
        }
        AcceptedEffect replaced{*trial.candidate, Compare(problem_, rest, trial.fit), {old}};
        for (CandidateRecord& r : out_.candidates) {
          if (r.effect == old && r.verdict == "accepted") r.verdict = "exchanged";
        }
        out_.candidates.push_back({trial.candidate->effect, VariantName(*trial.candidate), 0, 0,
                                   true, replaced.evidence, "accepted"});
        out_.effects.erase(out_.effects.begin() + static_cast<long>(i));
        out_.effects.push_back(std::move(replaced));
        out_.corrected = whole, out_.after = trial.fit;
      }
    }
  }

  void DropSuperfluous() {
    for (size_t i = 0; i < out_.effects.size() && out_.effects.size() > 1;) {
      FreeModel model;
      const FitResult rest = Without(i, &model);
      if (!rest.ok) return;
      const Evidence e = Compare(problem_, rest, out_.after);
      if (e.delta_bic >= options_.min_delta_bic && e.cross_validation_gain > 0 &&
          (e.estimation_gain > options_.min_gain ||
           e.best_channel_gain > options_.min_channel_gain)) {
        out_.effects[i].evidence = e;
        ++i;
        continue;
      }
      for (CandidateRecord& r : out_.candidates) {
        if (r.effect == out_.effects[i].candidate.effect && r.verdict == "accepted") {
          r.verdict = "superfluous beside the later ones";
        }
      }
      out_.effects.erase(out_.effects.begin() + static_cast<long>(i));
      out_.corrected = model, out_.after = rest;
      i = 0;
    }
  }

  void RankEffects() {
    std::stable_sort(out_.effects.begin(), out_.effects.end(), [](const auto& a, const auto& b) {
      return a.evidence.estimation_gain > b.evidence.estimation_gain;
    });
  }

  FitProblem& problem_;
  const SearchOptions options_;
  const Progress progress_;
  Identification out_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_{false};
  double share_ = 0;
};

}  // namespace

Evidence Compare(const FitProblem& problem, const FitResult& without, const FitResult& with) {
  const std::vector<double> independent = IndependentSamples(problem, with);
  const double total = std::accumulate(independent.begin(), independent.end(), 0.0);
  const double fall = LogVariance(without, independent) - LogVariance(with, independent);
  const double extra = double(with.values.size()) - double(without.values.size());
  Evidence e;
  e.delta_bic = total * fall - extra * std::log(total);
  double mean = 0;
  for (size_t c = 0; c < with.channel_ms.size(); ++c) {
    const double change = std::log(with.channel_ms[c] / without.channel_ms[c]);
    mean += change / static_cast<double>(with.channel_ms.size());
    const double gain = 1 - std::exp(0.5 * change);
    if (c == 0 || gain > e.best_channel_gain) {
      e.best_channel_gain = gain, e.best_channel = problem.data().outputs[c].name;
    }
  }
  e.estimation_gain = 1 - std::exp(0.5 * mean);
  e.cross_validation_gain =
      1 - std::exp(0.5 * (CrossValidatedLogVariance(problem, with, independent) -
                          CrossValidatedLogVariance(problem, without, independent)));
  return e;
}

Result<Identification> Identify(FitProblem* problem, const hydraulics::PhsParams& declared,
                                const SearchOptions& options, const Progress& progress) {
  return Search(problem, options, progress).Run(declared);
}

}  // namespace phs::identify::search
