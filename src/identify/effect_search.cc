#include "identify/effect_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <span>

#include "identify/effect_choice.h"
#include "identify/effect_options.h"
#include "identify/effect_reshape.h"
#include "identify/effect_trials.h"
#include "identify/effect_verdict.h"
#include "identify/formula_rounds.h"
#include "identify/near_fit.h"
#include "identify/reweigh.h"
#include "identify/seen_starts.h"
#include "identify/worst_place.h"

namespace phs::identify::search {

using measurement::FitData;
namespace {

class Search {
 public:
  Search(FitProblem* problem, FitProblem* coarse, const SearchOptions& options,
         const Progress& progress)
      : problem_(*problem), coarse_(*coarse), options_(options), progress_(progress) {}

  Result<Identification> Run(const hydraulics::PhsParams& declared) {
    ThreadBudget threads(options_.threads);
    for (FitProblem* p : {&problem_, &coarse_}) {
      p->SetGoOn([this] { return GoOn(); });
      p->SetThreads(&threads);
    }
    Result<Identification> out = SearchAll(declared);
    for (FitProblem* p : {&problem_, &coarse_}) p->SetGoOn({}), p->SetThreads(nullptr);
    return out;
  }

 private:
  Result<Identification> SearchAll(const hydraulics::PhsParams& declared) {
    out_.declared = problem_.forward().Declared(declared);
    std::vector<double> start;
    for (const auto& p : out_.declared.free) start.push_back(p.start);
    out_.before = problem_.Fit(out_.declared, start, 15);
    if (out_.before.ok) {
      const auto params = problem_.Params(out_.declared, out_.before.values);
      for (FitProblem* p : {&problem_, &coarse_}) {
        Result<SampleWeights> weights = p->CalcWeights(params);
        if (!weights.ok()) return weights.error();
        p->SetWeights(std::move(weights.value()));
      }
      out_.before = problem_.Fit(out_.declared, out_.before.values, 10);
    }
    if (out_.before.ok) {
      out_.before = FitNear(problem_, out_.declared, out_.before.values, out_.before.jacobian,
                            {.first_own = static_cast<int>(out_.declared.free.size()),
                             .max_steps = 8,
                             .balanced = true,
                             .final_jacobian = true});
    }
    out_.cancelled = cancelled_;
    if (cancelled_) return std::move(out_);
    if (!out_.before.ok) {
      return Error{declared.name, "the declared model could not be fitted",
                   "a model that can follow the measured motion", "check model and data"};
    }
    out_.corrected = out_.declared, out_.after = out_.before;
    for (int round = 0; round < options_.max_effects; ++round) {
      share_ = 0.02 + 0.6 * round / options_.max_effects;
      if (!AddOne(round)) break;
      if (!cancelled_) Reweigh(&problem_, &coarse_, &out_);
      if (out_.effects.size() > 1 && options_.thorough) {
        ReshapeEffects(
            problem_, coarse_, options_, [this](double) { return GoOn(); }, &out_);
      }
      if (IsNoise(out_.after)) break;
    }
    if (out_.effects.size() > 1) {
      Exchange();
      if (!cancelled_) Reweigh(&problem_, &coarse_, &out_);
      DropSuperfluous();
    }
    if (!cancelled_) ChallengeByFormula(problem_, coarse_, options_, &out_);
    if (!cancelled_) Reweigh(&problem_, &coarse_, &out_);
    if (!cancelled_ && AddFormula(problem_, coarse_, options_, &out_)) DropSuperfluous();
    UpdateRecords();
    RankEffects();
    out_.cancelled = cancelled_;
    return std::move(out_);
  }

  /// Every channel's residual is down at its noise: there is nothing left to find.
  static bool IsNoise(const FitResult& fit) {
    constexpr double kNoise = 1.04;  // mean square over that of noise and input
    return std::all_of(fit.channel_ms.begin(), fit.channel_ms.end(),
                       [](double ms) { return ms < kNoise; });
  }

  bool Tick(double part) {
    const std::lock_guard<std::mutex> lock(mutex_);
    part_ = part;
    if (!cancelled_ && progress_ && !progress_(std::min(0.99, share_ + part))) cancelled_ = true;
    return !cancelled_;
  }

  std::vector<FullTrial> Try(const FreeModel& model, const FitResult& fit,
                             const std::vector<Candidate>& list, int full_fits, double* reference,
                             double most_coarse = 1e300, double most_full = 1e300) {
    const size_t own = out_.declared.params.effects.size();
    const size_t present = model.params.effects.size() - own;
    const TrialOptions trying{.coarse_fits = options_.coarse_fits / (present > 0 ? 2 : 1),
                              .full_fits = std::max(2, full_fits - static_cast<int>(present)),
                              .elsewhere = options_.thorough && present < 2,
                              .thorough = options_.thorough && present == 0,
                              .declared = out_.declared.free.size(),
                              .most_coarse = most_coarse,
                              .most_full = most_full};
    return TryEffects(
        problem_, coarse_, model, fit, list, trying, [this](double part) { return Tick(part); },
        reference);
  }

  void Record(const std::vector<FullTrial>& trials, const FitResult& without, double reference,
              int round) {
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
      out_.candidates.push_back(std::move(record));
    }
  }

  bool AddOne(int round) {
    std::vector<Candidate> list = problem_.forward().Candidates(out_.corrected.params);
    KeepWorstPlace(problem_, out_.after, out_.corrected.params, &list);
    seen_.AddStarts(&list);
    double reference = 0;
    std::vector<FullTrial> trials =
        Try(out_.corrected, out_.after, list, options_.full_fits, &reference);
    if (cancelled_) return false;
    seen_.Note(trials, out_.after.values.size(), reference);
    const size_t first = out_.candidates.size();
    Record(trials, out_.after, reference, round);
    int best = -1;
    for (size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].fit.ok) continue;
      CandidateRecord& record = out_.candidates[first + i];
      const FreeModel model = WithCandidate(out_.corrected, trials[i].form);
      record.evidence.settled = IsSettled(model, trials[i].fit, trials[i].form);
      record.verdict = Verdict(record.evidence, OnBound(model, trials[i].fit, trials[i].form),
                               out_.effects.empty(), options_);
      if (!record.verdict.empty()) continue;
      record.verdict = kBeaten;
      if (best < 0 ||
          record.evidence.delta_bic > out_.candidates[first + best].evidence.delta_bic) {
        best = static_cast<int>(i);
      }
    }
    const std::span<CandidateRecord> records(out_.candidates.data() + first, trials.size());
    if (best < 0 || IsOverruled(problem_, trials, best, records)) return false;
    ShapeContained(problem_, out_.corrected, out_.after, best, &trials, records);
    best = FindSimplest(problem_, trials, records, best);
    CandidateRecord& chosen = records[best];
    chosen.verdict = "accepted";
    AcceptedEffect accepted{trials[best].form, chosen.evidence, {}};
    chosen.variant = VariantName(trials[best].form);
    for (size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].fit.ok || trials[i].candidate->effect == chosen.effect) continue;
      NoteConfusable(problem_, trials[best].fit, trials[i].fit, trials[i].candidate->effect,
                     options_, &accepted);
    }
    out_.corrected = WithCandidate(out_.corrected, trials[best].form);
    out_.after = trials[best].fit;
    out_.effects.push_back(std::move(accepted));
    return true;
  }

  /// Asked before every run of the model, so that a stop is heard at once.
  bool GoOn() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!cancelled_ && progress_ && !progress_(std::min(0.99, share_ + part_))) cancelled_ = true;
    return !cancelled_;
  }

  /// Tries to replace each accepted effect but the last by another.
  void Exchange() {
    constexpr double kHopeless = 0.15;  // ln of the mean square
    const double most_full =
        MeanLogSquare(out_.after.residual, problem_.num_channels()) + kHopeless;
    const double most = MostOfRivals(coarse_, out_.corrected, out_.after.values);
    for (size_t i = 0; i + 1 < out_.effects.size() && !cancelled_; ++i) {
      share_ = 0.68 + 0.1 * static_cast<double>(i);
      FreeModel model;
      const FitResult rest = FitWithout(problem_, out_, i, &model);
      if (!rest.ok) continue;
      std::vector<Candidate> list = problem_.forward().Candidates(model.params);
      KeepWorstPlace(problem_, rest, model.params, &list);
      const std::string old = out_.effects[i].candidate.effect;
      std::erase_if(list, [&](const Candidate& c) { return c.effect == old; });
      double reference = 0;
      std::vector<FullTrial> trials = Try(model, rest, list, 2, &reference, most, most_full);
      for (FullTrial& trial : trials) {
        if (!trial.fit.ok) continue;
        Evidence e = Compare(problem_, out_.after, trial.fit);
        const FreeModel whole = WithCandidate(model, trial.form);
        e.settled = IsSettled(whole, trial.fit, trial.form);
        if (e.delta_bic < options_.min_delta_bic || OnBound(whole, trial.fit, trial.form)) {
          continue;
        }
        if (FitsAsWellWithFewer(problem_, out_.after, trial.fit,
                                MarginOver(old, trial.candidate->effect))) {
          continue;
        }
        // What contains it must show what it has beyond it, as an effect beside it would.
        const bool more = IsNested(old, trial.candidate->effect);
        if (more && !Verdict(e, false, false, options_).empty()) continue;
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

  /// Every effect must still earn its place beside the others, by the rules of its acceptance.
  void DropSuperfluous() {
    for (size_t i = 0; i < out_.effects.size() && !cancelled_;) {
      FreeModel model;
      const FitResult rest =
          out_.effects.size() > 1 ? FitWithout(problem_, out_, i, &model) : out_.before;
      if (out_.effects.size() == 1) model = out_.declared;
      if (!rest.ok) return;
      const Evidence e = Compare(problem_, rest, out_.after);
      const bool alone = out_.effects.size() == 1;
      // Beside others its share of what exceeds the noise may be small.
      SearchOptions rules = options_;
      if (!alone) rules.min_excess_removed = 0;
      const std::string no = Verdict(e, false, alone, rules);
      // Nor does it go where the others would then have to take numbers that are not plausible.
      std::vector<AcceptedEffect> others = out_.effects;
      others.erase(others.begin() + static_cast<long>(i));
      if (no.empty() || AnyOnBound(model, rest, out_.declared.free.size(), others)) {
        out_.effects[i].evidence = e;
        ++i;
        continue;
      }
      const std::string gone = out_.effects[i].candidate.effect;
      Withdraw(gone, "superfluous beside the later ones", &out_.candidates);
      if (gone == "unlisted") out_.formula = {};
      out_.effects.erase(out_.effects.begin() + static_cast<long>(i));
      out_.corrected = model, out_.after = rest;
      i = 0;
    }
  }

  /// What is said of the accepted among the candidates is what was accepted in the end; what stands
  /// beside an effect is not confused with it.
  void UpdateRecords() {
    for (AcceptedEffect& effect : out_.effects) {
      std::erase_if(effect.confusable_with, [&](const std::string& name) {
        return std::any_of(out_.effects.begin(), out_.effects.end(),
                           [&](const auto& other) { return other.candidate.effect == name; });
      });
      if (effect.candidate.effect == "unlisted") continue;
      for (CandidateRecord& record : out_.candidates) {
        if (record.effect != effect.candidate.effect || record.verdict != "accepted") continue;
        record.variant = VariantName(effect.candidate), record.evidence = effect.evidence;
      }
    }
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
  SeenStarts seen_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_{false};
  double share_ = 0, part_ = 0;
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
