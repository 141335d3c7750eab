#include "identify/select/effect_search.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "effects/unlisted.h"
#include "identify/fit/accept.h"
#include "identify/fit/near_fit.h"
#include "identify/select/bent_form.h"
#include "identify/select/formula_rounds.h"
#include "identify/select/own_form.h"
#include "identify/select/points.h"
#include "identify/select/rivals.h"
#include "identify/select/test_question.h"
#include "identify/select/trials.h"
#include "identify/select/verdict.h"
#include "identify/select/worst_place.h"

namespace phs::identify::search {
namespace {

class Search {
 public:
  Search(FitProblem* problem, FitProblem* coarse, const SearchOptions& options,
         const Progress& progress)
      : problem_(*problem), coarse_(*coarse), options_(options), progress_(progress) {}

  Result<Identification> Run(const hydraulics::PhsParams& declared) {
    ThreadBudget threads(options_.effort.threads);
    for (FitProblem* p : {&problem_, &coarse_}) {
      p->SetGoOn([this] { return GoOn(part_); });
      p->SetThreads(&threads);
    }
    const Status done = SearchAll(declared);
    for (FitProblem* p : {&problem_, &coarse_}) p->SetGoOn({}), p->SetThreads(nullptr);
    out_.cancelled = cancelled_;
    if (!done.ok() && !cancelled_) return done.error();
    return std::move(out_);
  }

 private:
  Status SearchAll(const hydraulics::PhsParams& declared) {
    if (Status s = FitDeclared(declared); !s.ok()) return s;
    for (int round = 0; round < options_.effort.max_effects && !cancelled_; ++round) {
      if (!Advance(round)) break;
      Reweigh();
    }
    DropSuperfluous();
    Stage(0.85, 0.1);
    if (!cancelled_ && options_.formula && problem_.rule().formula) {
      ChallengeByFormula(problem_, coarse_, options_.effort, Asks(), &out_);
      const bool room = static_cast<int>(out_.effects.size()) < options_.effort.max_effects;
      if (room && AddFormula(problem_, coarse_, options_.effort, Asks(), &out_)) {
        const size_t beside = out_.effects.size();
        DropSuperfluous();
        if (out_.effects.size() < beside) SeekFormulaAnew();
      }
    }
    KeepPlainFit();
    UpdateRecords(&out_);
    return {};
  }

  /// Where something is left and nothing takes it, the numbers are those that leave least: the
  /// likelihood would let the discrepancy have what the numbers could. What theory leaves open is
  /// none of it.
  void KeepPlainFit() {
    if (!out_.effects.empty() || out_.before.powers.rows().empty()) return;
    const Likelihood& likelihood = problem_.likelihood();
    const std::vector<double> excess = likelihood.Excess(out_.before.powers);
    for (size_t b = 0; b < excess.size(); ++b) {
      const Block& block = likelihood.blocks()[b];
      if (excess[b] > kAsLargeAsNoise * block.count * block.present) out_.after = out_.before;
    }
  }

  /// An interval is centred on its number, which [-2 ln L] of 0.5 would leave 0.7 deviations off.
  static constexpr double kSettled = 0.02;

  Status FitDeclared(const hydraulics::PhsParams& declared) {
    out_.declared = problem_.forward().Declared(declared);
    std::vector<double> start;
    for (const auto& p : out_.declared.free) start.push_back(p.start);
    NearFitOptions plain{.max_steps = 15, .flat = true};
    // Most of the way in a part of the time.
    if (coarse_.num_rows() < problem_.num_rows() && !problem_.forward().CoarseRunsAsLong()) {
      const FitResult rough = FitNear(coarse_, out_.declared, start, {}, plain);
      if (rough.ok) start = rough.values;
    }
    out_.before = FitNear(problem_, out_.declared, start, {}, plain);
    plain.final_slopes = true;
    if (out_.before.ok) {
      if (Status s = SetWeights(out_.declared, out_.before.values); !s.ok()) return s;
      out_.before = FitNear(problem_, out_.declared, out_.before.values, {}, plain);
    }
    if (!out_.before.ok) {
      return Error{declared.name, "the declared model could not be fitted",
                   "a model that can follow the measured motion", "check model and data"};
    }
    out_.base = FitNear(problem_, out_.declared, out_.before.values, {},
                        {.max_steps = 8, .final_slopes = true, .enough = kSettled});
    if (!out_.base.ok) out_.base = out_.before;
    out_.corrected = out_.declared, out_.after = out_.base;
    return {};
  }

  Status SetWeights(const FreeModel& model, const std::vector<double>& values) {
    const auto params = problem_.Params(model, values);
    for (FitProblem* p : {&problem_, &coarse_}) {
      Result<Weighting> weights = p->CalcWeights(params);
      if (!weights.ok()) return weights.status();
      p->SetWeights(std::move(weights.value()));
    }
    return {};
  }

  /// The measured motion has noise; how much of it reaches an output depends on the model: a stiff
  /// bristle on a piston at rest turns a micrometre into newtons, the declared model does not.
  void Reweigh() {
    if (cancelled_ || !SetWeights(out_.corrected, out_.after.values).ok()) return;
    Refit(out_.declared, &out_.base), RefitCorrected();
    out_.before = FitNear(problem_, out_.declared, out_.before.values, {},
                          {.max_steps = 4, .flat = true, .final_slopes = true});
  }

  void Refit(const FreeModel& model, FitResult* fit) const {
    FitResult again = FitNear(problem_, model, fit->values, {},
                              {.max_steps = 6, .final_slopes = true, .enough = kSettled});
    if (again.ok) *fit = std::move(again);
  }

  void RefitCorrected() {
    do {
      Refit(out_.corrected, &out_.after);
    } while (problem_.rule().options && TakeOutEdges(&out_));
  }

  std::vector<FullTrial> Try(const FreeModel& model, const FitResult& fit,
                             const std::vector<Candidate>& list) {
    const bool elsewhere = options_.effort.elsewhere && problem_.rule().elsewhere &&
                           model.params.effects.size() == out_.declared.params.effects.size();
    // A model that an effect has made too stiff for the coarse clock is screened on the whole
    // record.
    for (FitProblem* screen : {&coarse_, &problem_}) {
      const std::vector<Point> points =
          PointsAbout(*screen, model, fit, out_.declared.free.size(), elsewhere);
      if (points.empty()) continue;
      reference_ = Criterion(*screen, points.front().score, points.front().values.size());
      KnownAnswers* known = screen == &coarse_ ? &known_ : nullptr;
      return TryEffects(problem_, *screen, model, fit, points, list, options_.effort, Asks(),
                        known);
    }
    return {};
  }

  /// One effect more. What the form of the effect before may take on can stand for it (a hose that
  /// creeps ever more slowly, for a leak): so it is sought beside the core of that effect, too.
  bool Advance(int round) {
    const double begin = 0.02 + 0.2 * round;
    Stage(begin, HasOptions(out_) ? 0.1 : 0.2);
    Identification core = out_;
    if (!AddOne(round)) return false;
    if (cancelled_ || !TakeOutOptions(&core)) return true;
    Stage(begin + 0.1, 0.1);
    Identification whole = std::exchange(out_, std::move(core));
    if (!AddOne(round) || Total(whole) <= Total(out_)) out_ = std::move(whole);
    return true;
  }

  double Total(const Identification& found) const {
    return Criterion(problem_, found.after.score, found.after.values.size());
  }

  /// Of the effect accepted last: numbers beside those of its core.
  static bool HasOptions(const Identification& found) {
    if (found.effects.empty()) return false;
    const Candidate& last = found.effects.back().candidate;
    return last.free.size() > last.none.size();
  }

  /// The fit without effect i of those found.
  FitResult FitWithout(const Identification& found, size_t i, FreeModel* model) const {
    const std::vector<double> values = ValuesWithout(found, i, model);
    if (found.effects.size() == 1) return found.base;
    return FitNear(problem_, *model, values, {}, {.max_steps = 8, .final_slopes = true});
  }

  /// Leaves the core alone of the last effect; false where it has no more than that.
  bool TakeOutOptions(Identification* found) const {
    if (!HasOptions(*found)) return false;
    FreeModel model;
    const FitResult beneath = FitWithout(*found, found->effects.size() - 1, &model);
    KeepCore(found);
    found->after = FitNear(problem_, found->corrected, found->after.values, {},
                           {.max_steps = 8, .final_slopes = true});
    if (!found->after.ok || !beneath.ok) return false;
    found->effects.back().evidence = Compare(problem_, beneath, found->after, 1);
    return true;
  }

  bool AddOne(int round) {
    std::vector<Candidate> list = problem_.forward().Candidates(out_.corrected.params);
    KeepWorstPlace(problem_, out_.corrected, out_.after, &list);
    // The least that one more number and so many structures cost: what is left must be worth it.
    const double most =
        problem_.likelihood().MostGain(out_.after.powers) - std::log(problem_.likelihood().Count());
    if (!IsBeyondChance(problem_.rule(), most, static_cast<double>(list.size()))) return false;
    std::vector<FullTrial> trials = Try(out_.corrected, out_.after, list);
    if (cancelled_) return false;
    const size_t first = out_.candidates.size();
    std::vector<FullTrial> passed;
    int best = -1;
    for (const FullTrial& trial : trials) {
      CandidateRecord record{trial.candidate->effect,
                             VariantName(trial.form),
                             round + 1,
                             trial.fails ? 0 : reference_ - trial.promise,
                             false,
                             {},
                             {}};
      record.fitted = trial.fit.ok;
      record.verdict = trial.fails ? "the model cannot be run with it" : "screened out";
      if (trial.fit.ok) {
        record.evidence =
            Compare(problem_, out_.after, trial.fit, static_cast<double>(list.size()));
        record.verdict = Refusal(problem_.rule(), record.evidence, trial.form, trial.fit);
        if (record.verdict == kNotTold) {
          record.at_end = AmountsAtEnd(trial.form, trial.fit, out_.after.values.size());
        }
      }
      if (record.verdict.empty()) {
        record.verdict = kBeaten;
        passed.push_back(trial);
        if (best < 0 ||
            Beats(problem_, trial.form, trial.fit, trials[static_cast<size_t>(best)].form,
                  trials[static_cast<size_t>(best)].fit)) {
          best = static_cast<int>(out_.candidates.size() - first);
        }
      }
      out_.candidates.push_back(std::move(record));
    }
    if (best < 0) return false;
    CandidateRecord& record = out_.candidates[first + static_cast<size_t>(best)];
    const FullTrial& trial = trials[static_cast<size_t>(best)];
    AcceptedEffect effect = BesideRivals(problem_, trial, record.evidence, passed);
    record.verdict = kAccepted;
    out_.corrected = WithCandidate(out_.corrected, trial.form);
    out_.after = trial.fit;
    out_.effects.push_back(std::move(effect));
    return true;
  }

  /// Every effect must still earn its place beside the others.
  void DropSuperfluous() {
    for (size_t i = 0; problem_.rule().superfluous && i < out_.effects.size() && !cancelled_;) {
      FreeModel model;
      FitResult rest = FitWithout(out_, i, &model);
      if (!rest.ok) return;
      const Evidence e = Compare(problem_, rest, out_.after, 1);
      const SearchRule& rule = problem_.rule();
      const bool told = !rule.beyond_zero || IsToldInTheEnd(out_, i);
      const bool gains = !rule.cross_validation || e.cross_validation_gain > 0;
      std::string why = told ? "superfluous beside the later ones" : kNotTold;
      if (told && gains && IsBeyondChance(rule, e.delta_bic, 1)) {
        const std::string host = FormOf(i, model, rest);
        if (host.empty()) {
          ++i;
          continue;
        }
        why = "another form of " + host + " would explain most of it";
      }
      const std::string gone = out_.effects[i].candidate.effect;
      Withdraw(gone, why, &out_.candidates);
      if (gone == effects::UnlistedInfo().name) out_.formula = {};
      out_.effects.erase(out_.effects.begin() + static_cast<long>(i));
      out_.corrected = model, out_.after = std::move(rest);
      if (rule.options && TakeOutEdges(&out_)) RefitCorrected();
      i = 0;
    }
  }

  /// A formula whose companion went has more to tell.
  void SeekFormulaAnew() {
    const auto formula = std::find_if(out_.effects.begin(), out_.effects.end(), IsFormula);
    if (formula == out_.effects.end() || cancelled_) return;
    Identification before = out_;
    FreeModel model;
    const std::vector<double> values =
        ValuesWithout(out_, static_cast<size_t>(formula - out_.effects.begin()), &model);
    out_.after = FitNear(problem_, model, values, {}, {.max_steps = 8, .final_slopes = true});
    out_.corrected = model, out_.effects.erase(formula), out_.formula = {};
    Withdraw(effects::UnlistedInfo().name, "sought anew beside fewer effects", &out_.candidates);
    const bool found = out_.after.ok &&
                       AddFormula(problem_, coarse_, options_.effort, Asks(), &out_) &&
                       Criterion(problem_, out_.after.score, out_.after.values.size()) <
                           Criterion(problem_, before.after.score, before.after.values.size());
    found ? DropSuperfluous() : void(out_ = std::move(before));
  }

  /// The stronger effect whose form effect i is; a formula that is said as such stays.
  std::string FormOf(size_t i, const FreeModel& model, const FitResult& rest) const {
    if (!problem_.rule().bends || out_.effects.size() < 2) return {};
    if (IsFormula(out_.effects[i]) && HasOwnForm(out_)) return {};
    const std::optional<size_t> host = IsFormOf(problem_, out_, i, model, rest);
    return host ? out_.effects[*host].candidate.effect : "";
  }

  std::function<bool(double)> Asks() {
    return [this](double part) { return GoOn(part); };
  }
  void Stage(double begin, double length) { begin_ = begin, length_ = length; }

  /// Asked before every run of the model, so that a stop is heard at once.
  bool GoOn(double part) {
    const std::lock_guard<std::mutex> lock(mutex_);
    part_ = part;
    const double share = std::min(0.99, begin_ + length_ * part);
    if (!cancelled_ && progress_ && !progress_(share)) cancelled_ = true;
    return !cancelled_;
  }

  FitProblem& problem_;
  FitProblem& coarse_;
  const SearchOptions options_;
  const Progress progress_;
  Identification out_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_{false};
  std::atomic<double> part_{0};
  double begin_ = 0, length_ = 0.02;
  KnownAnswers known_;    ///< on the coarse record
  double reference_ = 0;  ///< criterion of the model beneath, on the coarse record
};

}  // namespace

Result<Identification> Identify(FitProblem* problem, const hydraulics::PhsParams& declared,
                                const SearchOptions& options, const Progress& progress) {
  if (Status s = CheckBetween(problem->forward(), declared, options.between); !s.ok()) {
    return s.error();
  }
  Result<FitProblem> coarse = problem->Coarse(declared, options.effort.coarse_step_s);
  if (!coarse.ok()) return coarse.error();
  return Search(problem, &coarse.value(), options, progress).Run(declared);
}

}  // namespace phs::identify::search
