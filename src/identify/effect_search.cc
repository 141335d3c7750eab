#include "identify/effect_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "identify/driven_formula.h"
#include "identify/effect_form.h"
#include "identify/near_fit.h"
#include "identify/screening.h"

namespace phs::identify::search {
namespace {

constexpr const char* kNotPlausible = "value not plausible";

/// True if the amount of the candidate ended on a bound: not plausible, or not there. Where it has
/// two amounts, one of them may be nil.
bool OnBound(const FreeModel& model, const FitResult& fit, const Candidate& candidate) {
  constexpr double kTiny = 1e-3;
  const size_t base = model.free.size() - candidate.free.size();
  int nil = 0;
  for (int k = 0; k < candidate.mains; ++k) {
    const FreeParameter& p = model.free[base + static_cast<size_t>(k)];
    const double x = p.ToCoordinate(fit.values[base + static_cast<size_t>(k)]);
    const double low = p.ToCoordinate(p.low), high = p.ToCoordinate(p.high);
    if (high - x < kTiny * (high - low)) return true;
    nil += x - low < kTiny * (high - low);
  }
  return nil == candidate.mains;
}

/// A screened candidate and, for the best, its form with options and its fit to the whole record.
struct FullTrial : Trial {
  Candidate form;
  FitResult fit;
};

class Search {
 public:
  Search(FitProblem* problem, FitProblem* coarse, const SearchOptions& options,
         const Progress& progress)
      : problem_(*problem), coarse_(*coarse), options_(options), progress_(progress) {}

  Result<Identification> Run(const hydraulics::PhsParams& declared) {
    out_.declared = problem_.forward().Declared(declared);
    std::vector<double> start;
    for (const auto& p : out_.declared.free) start.push_back(p.start);
    out_.before = problem_.Fit(out_.declared, start, 15);
    if (out_.before.ok) {
      const auto params = problem_.Params(out_.declared, out_.before.values);
      if (const Status s = problem_.SetWeights(params); !s.ok()) return s.error();
      if (const Status s = coarse_.SetWeights(params); !s.ok()) return s.error();
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
    TryFormula();
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

  /// Where candidates are tried: the best fit and, where it lies elsewhere, the
  /// fit to what most of the record says; a rare strong deviation may have
  /// drawn the first far off.
  std::vector<std::vector<double>> Points(const FreeModel& model, const FitResult& fit) const {
    constexpr double kElsewhere = 0.03;
    std::vector<std::vector<double>> points = {fit.values};
    if (!options_.thorough) return points;
    std::vector<double> start = fit.values;
    for (size_t i = 0; i < out_.declared.free.size(); ++i) start[i] = model.free[i].start;
    const FitResult most = FitNear(coarse_, model, start, {}, {.max_steps = 12, .robust = 2.5});
    if (most.ok && AreApart(model, most.values, fit.values, kElsewhere)) {
      points.push_back(most.values);
    }
    return points;
  }

  /// A strong effect may have bent the baseline's volumes so far that its own numbers have no way
  /// back from there: hydraulic effects start from the declared volumes too.
  bool AddDeclaredPoint(const FreeModel& model, std::vector<std::vector<double>>* points) const {
    constexpr double kFar = 0.2;
    std::vector<double> declared = points->front();
    for (size_t i = 0; i < out_.declared.free.size(); ++i) {
      const std::string& name = model.free[i].name;
      if (name.ends_with("_volume_m3")) declared[i] = model.free[i].start;
    }
    for (const auto& point : *points) {
      if (!AreApart(model, declared, point, kFar)) return false;
    }
    points->push_back(std::move(declared));
    return true;
  }

  static bool AreApart(const FreeModel& model, const std::vector<double>& a,
                       const std::vector<double>& b, double least) {
    for (size_t i = 0; i < a.size(); ++i) {
      const FreeParameter& p = model.free[i];
      if (p.logarithmic && std::abs(p.ToCoordinate(a[i]) - p.ToCoordinate(b[i])) > least) {
        return true;
      }
    }
    return false;
  }

  /// Screens candidates on top of `model` and fits the best `full_fits` effects
  /// in full.
  std::vector<FullTrial> Try(const FreeModel& model, const FitResult& fit,
                             const std::vector<Candidate>& list, int full_fits, double* reference) {
    ScreeningOptions screening{
        options_.threads, options_.coarse_fits,
        options_.thorough && model.params.effects.size() == out_.declared.params.effects.size()};
    std::vector<std::vector<double>> points = Points(model, fit);
    if (screening.thorough && AddDeclaredPoint(model, &points)) {
      screening.hydraulic_from = points.size() - 1;
    }
    std::vector<Trial> found = ScreenCandidates(
        coarse_, model, points, list, screening, [&](double part) { return Tick(0.15 * part); },
        reference);
    std::vector<FullTrial> trials;
    for (Trial& trial : found) trials.push_back({std::move(trial), *trial.candidate, {}});
    std::vector<int> chosen;
    for (int i = 0; i < static_cast<int>(trials.size()); ++i) {
      if (!trials[i].coarse.ok || static_cast<int>(chosen.size()) >= full_fits) continue;
      const std::string& effect = trials[i].candidate->effect;
      if (std::none_of(chosen.begin(), chosen.end(),
                       [&](int k) { return trials[k].candidate->effect == effect; })) {
        chosen.push_back(i);
      }
    }
    std::atomic<int> done{0};
    InParallel(static_cast<int>(chosen.size()), options_.threads, [&](int k) {
      if (!Tick(0.15 + 0.15 * done++ / static_cast<double>(chosen.size()))) return;
      FullTrial& trial = trials[chosen[k]];
      trial.coarse = ShapeForm(coarse_, model, trial.coarse, &trial.form);
      const FreeModel whole = WithCandidate(model, trial.form);
      trial.fit =
          FitNear(problem_, whole, trial.coarse.values, {}, {.first_own = 0, .max_steps = 1});
      if (!trial.fit.ok) return;
      const int count = static_cast<int>(trial.fit.values.size());
      trial.fit = FitNear(problem_, whole, trial.fit.values, trial.fit.jacobian,
                          {.first_own = count, .max_steps = 6, .final_jacobian = true});
    });
    return trials;
  }

  void Record(const std::vector<FullTrial>& trials, const FitResult& without, double reference,
              int round, std::vector<size_t>* places) {
    for (const FullTrial& trial : trials) {
      CandidateRecord record;
      record.effect = trial.candidate->effect;
      record.variant = VariantName(*trial.candidate);
      record.round = round + 1;
      record.screening_gain = 1 - std::exp(0.5 * (trial.predicted - reference));
      record.fitted = trial.fit.ok;
      record.verdict = "screened out";
      if (trial.coarse.ok) {
        record.coarse_gain =
            1 - std::exp(0.5 * (MeanLogSquare(trial.coarse.residual, problem_.num_channels()) -
                                reference));
      }
      if (trial.fit.ok) record.evidence = Compare(problem_, without, trial.fit);
      places->push_back(out_.candidates.size());
      out_.candidates.push_back(std::move(record));
    }
  }

  std::string Verdict(const FullTrial& trial, const Evidence& e, const FreeModel& model) const {
    if (e.delta_bic < options_.min_delta_bic) return "not significant";
    if (e.cross_validation_gain <= 0) return "no gain in cross-validation";
    if (e.estimation_gain < options_.min_gain && e.best_channel_gain < options_.min_channel_gain) {
      return "gain too small";
    }
    if (OnBound(model, trial.fit, trial.form)) return kNotPlausible;
    const double least =
        out_.effects.empty() ? options_.min_first_removed : options_.min_excess_removed;
    if (e.excess_removed < least && e.best_channel_gain < 0.5) {
      return "explains too little of what is left";
    }
    return "";
  }

  bool AddOne(int round) {
    const std::vector<Candidate> list = problem_.forward().Candidates(out_.corrected.params);
    double reference = 0;
    std::vector<FullTrial> trials =
        Try(out_.corrected, out_.after, list, options_.full_fits, &reference);
    if (cancelled_) return false;
    std::vector<size_t> places;
    Record(trials, out_.after, reference, round, &places);
    int best = -1;
    for (size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].fit.ok) continue;
      CandidateRecord& record = out_.candidates[places[i]];
      const FreeModel model = WithCandidate(out_.corrected, trials[i].form);
      record.verdict = Verdict(trials[i], record.evidence, model);
      if (!record.verdict.empty()) continue;
      record.verdict = "another explains more";
      if (best < 0 ||
          record.evidence.delta_bic > out_.candidates[places[best]].evidence.delta_bic) {
        best = static_cast<int>(i);
      }
    }
    if (best < 0 || Overruled(trials, places, best)) return false;
    CandidateRecord& chosen = out_.candidates[places[best]];
    chosen.verdict = "accepted";
    AcceptedEffect accepted{trials[best].form, chosen.evidence, {}};
    chosen.variant = VariantName(trials[best].form);
    for (size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].fit.ok || trials[i].candidate->effect == chosen.effect) continue;
      NoteConfusable(trials[best].fit, trials[i], &accepted);
    }
    out_.corrected = WithCandidate(out_.corrected, trials[best].form);
    out_.after = trials[best].fit;
    out_.effects.push_back(std::move(accepted));
    return true;
  }

  /// True if one whose numbers are not plausible explains far more than the best plausible one: the
  /// truth is then of a form that the catalogue lacks, and no lesser effect is bent to stand for
  /// it.
  bool Overruled(const std::vector<FullTrial>& trials, const std::vector<size_t>& places,
                 int best) {
    constexpr double kFar = 0.4;  // ln of the mean square
    const int channels = problem_.num_channels();
    const double mine = MeanLogSquare(trials[best].fit.residual, channels);
    for (size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].fit.ok || out_.candidates[places[i]].verdict != kNotPlausible) continue;
      if (MeanLogSquare(trials[i].fit.residual, channels) > mine - kFar) continue;
      out_.candidates[places[best]].verdict =
          trials[i].candidate->effect + " explains far more, with numbers that are not plausible";
      return true;
    }
    return false;
  }

  /// Others whose residual is within the margin and whose evidence is not far
  /// behind.
  void NoteConfusable(const FitResult& best, const FullTrial& other,
                      AcceptedEffect* accepted) const {
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
    FitResult fit = FitNear(problem_, *model, start, {}, {.first_own = 0, .max_steps = 1});
    if (!fit.ok) return fit;
    return FitNear(problem_, *model, fit.values, fit.jacobian,
                   {.first_own = static_cast<int>(model->free.size()),
                    .max_steps = 8,
                    .final_jacobian = true});
  }

  /// Tries to replace each accepted effect but the last by another.
  void Exchange() {
    for (size_t i = 0; i + 1 < out_.effects.size() && !cancelled_; ++i) {
      share_ = 0.85;
      FreeModel model;
      const FitResult rest = Without(i, &model);
      if (!rest.ok) continue;
      std::vector<Candidate> list = problem_.forward().Candidates(model.params);
      const std::string old = out_.effects[i].candidate.effect;
      std::erase_if(list, [&](const Candidate& c) { return c.effect == old; });
      double reference = 0;
      std::vector<FullTrial> trials = Try(model, rest, list, 2, &reference);
      for (FullTrial& trial : trials) {
        if (!trial.fit.ok) continue;
        const Evidence e = Compare(problem_, out_.after, trial.fit);
        const FreeModel whole = WithCandidate(model, trial.form);
        if (e.delta_bic < options_.min_delta_bic || OnBound(whole, trial.fit, trial.form)) {
          continue;
        }
        AcceptedEffect replaced{trial.form, Compare(problem_, rest, trial.fit), {old}};
        Withdraw(old, "exchanged", &out_.candidates);
        out_.candidates.push_back({trial.candidate->effect, VariantName(trial.form), 0, 0, 0, true,
                                   replaced.evidence, "accepted"});
        out_.effects.erase(out_.effects.begin() + static_cast<long>(i));
        out_.effects.push_back(std::move(replaced));
        out_.corrected = whole, out_.after = trial.fit;
        break;
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
      Withdraw(out_.effects[i].candidate.effect, "superfluous beside the later ones",
               &out_.candidates);
      out_.effects.erase(out_.effects.begin() + static_cast<long>(i));
      out_.corrected = model, out_.after = rest;
      i = 0;
    }
  }

  /// A force by formula for what the load cell still shows.
  void TryFormula() {
    constexpr double kNoise = 1.1, kMostForce_N = 1e5;
    const int load = problem_.FindOutput("load_cell_N");
    if (cancelled_ || load < 0 || out_.after.channel_ms[static_cast<size_t>(load)] < kNoise) return;
    const FoundFormula found = SearchForceFormula(problem_, out_.corrected, out_.after,
                                                  {.threshold = options_.min_delta_bic});
    if (found.empty()) return;
    const Candidate candidate = FormulaCandidate(found, kMostForce_N);
    const FreeModel whole = WithCandidate(out_.corrected, candidate);
    std::vector<double> start = out_.after.values;
    start.insert(start.end(), candidate.starts[0].begin(), candidate.starts[0].end());
    const FitResult with = FitNear(problem_, whole, start, out_.after.jacobian,
                                   {.first_own = static_cast<int>(out_.after.values.size()),
                                    .max_steps = 8,
                                    .final_jacobian = true});
    if (!with.ok) return;
    CandidateRecord record{"unlisted",
                           found.text,
                           0,
                           found.gain,
                           found.gain,
                           true,
                           Compare(problem_, out_.after, with),
                           "accepted"};
    const Evidence& e = record.evidence;
    const double load_gain = 1 - std::sqrt(with.channel_ms[static_cast<size_t>(load)] /
                                           out_.after.channel_ms[static_cast<size_t>(load)]);
    if (e.delta_bic < options_.min_delta_bic) {
      record.verdict = "not significant";
    } else if (e.cross_validation_gain <= 0) {
      record.verdict = "no gain in cross-validation";
    } else if (load_gain <
                   (out_.effects.empty() ? options_.min_channel_gain : options_.min_formula_gain) ||
               e.excess_removed < options_.min_first_removed) {
      record.verdict = "explains too little of what is left";
    }
    out_.candidates.push_back(record);
    if (record.verdict != "accepted") return;
    out_.effects.push_back({candidate, e, {}});
    out_.corrected = whole, out_.after = with, out_.formula = found;
  }

  void RankEffects() {
    std::stable_sort(out_.effects.begin(), out_.effects.end(), [](const auto& a, const auto& b) {
      return a.evidence.estimation_gain > b.evidence.estimation_gain;
    });
  }

  FitProblem& problem_;
  FitProblem& coarse_;
  const SearchOptions options_;
  const Progress progress_;
  Identification out_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_{false};
  double share_ = 0;
};

}  // namespace

Result<Identification> Identify(FitProblem* problem, const hydraulics::PhsParams& declared,
                                const SearchOptions& options, const Progress& progress) {
  const FitData& data = problem->data();
  const int stride = std::max(1, static_cast<int>(options.coarse_step_s / data.step_s + 0.01));
  Result<FitProblem> coarse = problem->Thinned(declared, stride);
  if (!coarse.ok()) return coarse.error();
  return Search(problem, &coarse.value(), options, progress).Run(declared);
}

}  // namespace phs::identify::search
