#include "identify/element_search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "identify/driven_formula.h"
#include "identify/element_places.h"
#include "rigs/rig_model.h"

namespace phs::identify::element {
namespace {

using search::Candidate;
using search::WithCandidate;

struct Trial {
  const Candidate* candidate = nullptr;
  std::vector<double> start;  ///< of all numbers, after the predicted step
  double predicted = 1e300;   ///< mean square that one linear step promises
  ElementFit fit;
  ElementEvidence evidence;
};

class Search {
 public:
  Search(ElementProblem* problem, const ElementSearchOptions& options,
         const ElementProgress& progress)
      : problem_(*problem), options_(options), threads_(options.threads), progress_(progress) {}

  Status FitDeclared(const hydraulics::PhsParams& declared, const std::vector<std::string>& free) {
    out_.sizes = MeasureSizes(problem_.data());
    Result<FreeModel> model = DeclaredElement(declared, free, out_.sizes);
    if (!model.ok()) return model.status();
    out_.declared = std::move(model.value());
    std::vector<double> start;
    for (const auto& p : out_.declared.free) start.push_back(p.start);
    if (Status s = problem_.SetWeights(declared, out_.sizes.force_N); !s.ok()) return s;
    // The level of the residual settles in a few rounds; it is what the weights rest on.
    for (int round = 0; round < 4; ++round) {
      out_.before = problem_.Fit(out_.declared, start, round == 0 ? 40 : 8);
      if (!out_.before.ok) {
        return Error{declared.name, "the declared model could not be fitted",
                     "a model that can follow the measured motion", "check model and data"};
      }
      start = out_.before.values;
      if (round == 3) break;
      const auto params = problem_.Params(out_.declared, start);
      if (Status s = problem_.SetWeights(params, Level(params)); !s.ok()) return s;
    }
    out_.corrected = out_.declared, out_.after = out_.before;
    SetFrictionSize();
    return {};
  }

  void Select() {
    for (int round = 0; round < options_.max_effects && !cancelled_; ++round) {
      share_ = 0.1 + 0.15 * round;
      if (!AddOne(round)) break;
    }
    DropSuperfluous();
  }

  void FindFormula() {
    share_ = 0.88;
    if (!Tick(0) || out_.corrected.params.friction.model == hydraulics::FrictionModel::kNone)
      return;
    TryFormula(out_.corrected, out_.after, nullptr);
    // Does a formula say it better than one of the listed effects?
    for (size_t i = 0; i < out_.effects.size() && Tick(0.05); ++i) {
      if (out_.effects[i].candidate.effect == "unlisted") continue;
      FreeModel model;
      const ElementFit rest = Without({i, FormulaIndex()}, &model);
      if (rest.ok && TryFormula(model, rest, &out_.effects[i])) return;
    }
  }

  ElementIdentification Finish() {
    std::stable_sort(out_.effects.begin(), out_.effects.end(), [](const auto& a, const auto& b) {
      return a.evidence.delta_bic > b.evidence.delta_bic;
    });
    out_.cancelled = cancelled_;
    return std::move(out_);
  }

 private:
  bool Tick(double part) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!cancelled_ && progress_ && !progress_(std::min(1.0, share_ + part))) cancelled_ = true;
    return !cancelled_;
  }

  /// Robust level of the residual [N] on the rows that are fitted.
  double Level(const hydraulics::PhsParams& params) const {
    const auto predicted = problem_.Predict(params);
    PHS_CHECK(predicted.ok());
    std::vector<double> r;
    for (size_t k = 0; k < problem_.data().records.size(); ++k) {
      const ElementRecord& record = problem_.data().records[k];
      for (size_t i = 0; i < record.fitted.size(); ++i) {
        if (record.fitted[i])
          r.push_back(std::abs(record.row_force_N[i] - predicted.value()[k][i]));
      }
    }
    std::nth_element(r.begin(), r.begin() + static_cast<long>(r.size() * 68 / 100), r.end());
    return std::max(r[r.size() * 68 / 100], problem_.data().noise_N);
  }

  void SetFrictionSize() {
    const auto params = problem_.Params(out_.corrected, out_.after.values);
    Result<rigs::RigModel> rig = rigs::RigModel::Create(rigs::RigKind::kElement, params);
    if (!rig.ok()) return;
    const hydraulics::FrictionPlace place;
    const double level = rig.value().system().friction(0).Level(1, out_.sizes.speed_m_s, place);
    if (level > 0) out_.sizes.friction_N = level;
    out_.sizes.ramp_m_s = params.friction.ramp_speed_m_s;
  }

  bool AddOne(int round) {
    const std::vector<Candidate> list =
        ListElementCandidates(out_.corrected, problem_.data(), out_.sizes);
    std::vector<Trial> trials(list.size());
    std::atomic<int> done{0};
    threads_.ForEach(static_cast<int>(list.size()), [&](int i) {
      if (!Tick(0.05 * done++ / static_cast<double>(list.size()))) return;
      trials[static_cast<size_t>(i)] = Screen(list[static_cast<size_t>(i)]);
    });
    std::vector<size_t> order;
    for (size_t i = 0; i < trials.size(); ++i) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return trials[a].predicted < trials[b].predicted; });
    const int fits = std::min<int>(options_.full_fits, static_cast<int>(order.size()));
    done = 0;
    threads_.ForEach(fits, [&](int i) {
      if (!Tick(0.05 + 0.09 * done++ / fits)) return;
      FitTrial(&trials[order[static_cast<size_t>(i)]]);
    });
    if (cancelled_) return false;
    int best = -1;
    const size_t first = out_.candidates.size();
    for (size_t i = 0; i < trials.size(); ++i) {
      ElementRecordOfTrial record{list[i].effect, search::VariantName(list[i]), round + 1,
                                  trials[i].evidence, "screened out"};
      if (trials[i].fit.ok) record.verdict = Verdict(trials[i]);
      const bool good = record.verdict.empty();
      if (good) record.verdict = "another explains more";
      out_.candidates.push_back(record);
      if (!good) continue;
      if (best < 0 ||
          trials[i].evidence.delta_bic > trials[static_cast<size_t>(best)].evidence.delta_bic) {
        best = static_cast<int>(i);
      }
    }
    if (best < 0) return false;
    const Trial& chosen = trials[static_cast<size_t>(best)];
    out_.candidates[first + static_cast<size_t>(best)].verdict = "accepted";
    AcceptedElementEffect accepted{*chosen.candidate, chosen.evidence, {}};
    for (const Trial& other : trials) {
      if (!other.fit.ok || other.candidate->effect == chosen.candidate->effect) continue;
      const ElementEvidence e = CompareFits(other.fit, chosen.fit);
      if (e.delta_bic > options_.min_delta_bic || e.estimation_gain > options_.margin) continue;
      auto& names = accepted.confusable_with;
      if (std::find(names.begin(), names.end(), other.candidate->effect) == names.end()) {
        names.push_back(other.candidate->effect);
      }
    }
    out_.corrected = WithCandidate(out_.corrected, *chosen.candidate);
    out_.after = chosen.fit;
    out_.effects.push_back(std::move(accepted));
    Settle();
    return true;
  }

  /// After an effect has come in: weights for the new level, and the declared numbers from their
  /// declared values as well, since a strong effect that was missing may have driven them away.
  void Settle() {
    for (int round = 0; round < 2 && !cancelled_; ++round) {
      const auto params = problem_.Params(out_.corrected, out_.after.values);
      if (!problem_.SetWeights(params, Level(params)).ok()) return;
      std::vector<double> fresh = out_.after.values;
      for (size_t i = 0; i < out_.declared.free.size(); ++i) fresh[i] = out_.declared.free[i].start;
      ElementFit again = problem_.Fit(out_.corrected, fresh, 20);
      ElementFit on = problem_.Fit(out_.corrected, out_.after.values, 8);
      if (again.ok && (!on.ok || again.mean_square < on.mean_square)) on = std::move(again);
      if (on.ok) out_.after = std::move(on);
    }
    SetFrictionSize();
  }

  /// Best start of one candidate by a predicted Gauss–Newton step over all free numbers.
  Trial Screen(const Candidate& candidate) const {
    Trial best;
    best.candidate = &candidate;
    const FreeModel model = WithCandidate(out_.corrected, candidate);
    const int base = static_cast<int>(out_.corrected.free.size());
    const int count = static_cast<int>(model.free.size());
    for (const auto& start : candidate.starts) {
      std::vector<double> values = out_.after.values;
      values.insert(values.end(), start.begin(), start.end());
      Eigen::VectorXd r;
      Eigen::MatrixXd own;
      if (!problem_.Evaluate(model, values, &r, &own, base)) continue;
      Eigen::MatrixXd j(r.size(), count);
      j << out_.after.jacobian, own;
      Eigen::MatrixXd normal = j.transpose() * j;
      const Eigen::VectorXd damping = 1e-5 * normal.diagonal();
      normal.diagonal() += damping;
      normal.diagonal().array() += 1e-12 * normal.trace() + 1e-300;
      Eigen::VectorXd step = normal.ldlt().solve(-j.transpose() * r);
      for (int i = 0; i < count; ++i) {
        const FreeParameter& p = model.free[static_cast<size_t>(i)];
        const double x = p.ToCoordinate(values[static_cast<size_t>(i)]);
        const double reach = p.logarithmic ? 1.0 : 1e300;
        step[i] = std::clamp(step[i], std::max(-reach, p.ToCoordinate(p.low) - x),
                             std::min(reach, p.ToCoordinate(p.high) - x));
      }
      // What is promised may not come; what is there already counts as well.
      const double here = r.squaredNorm() / static_cast<double>(r.size());
      const double promised = (r + j * step).squaredNorm() / static_cast<double>(r.size());
      const double score = std::min(here, std::max(promised, 0.01 * out_.after.mean_square));
      if (score >= best.predicted) continue;
      best.predicted = score;
      best.start.clear();
      for (int i = 0; i < count; ++i) {
        const FreeParameter& p = model.free[static_cast<size_t>(i)];
        const double at = p.ToCoordinate(values[static_cast<size_t>(i)]);
        best.start.push_back(p.FromCoordinate(at + (here <= promised ? 0 : step[i])));
      }
    }
    return best;
  }

  void FitTrial(Trial* trial) const {
    if (trial->start.empty()) return;
    const FreeModel model = WithCandidate(out_.corrected, *trial->candidate);
    trial->fit = problem_.Fit(model, trial->start, 12);
    if (trial->fit.ok) trial->evidence = CompareFits(out_.after, trial->fit);
  }

  std::string Verdict(const Trial& trial) const {
    const ElementEvidence& e = trial.evidence;
    if (e.delta_bic < options_.min_delta_bic) return "not significant";
    if (e.cross_validation_gain <= 0) return "no gain in cross-validation";
    if (e.estimation_gain < options_.min_gain) return "gain too small";
    const size_t base = out_.corrected.free.size();
    for (size_t i = 0; i < trial.candidate->free.size(); ++i) {
      const FreeParameter& p = trial.candidate->free[i];
      const double x = p.ToCoordinate(trial.fit.values[base + i]);
      const double low = p.ToCoordinate(p.low), high = p.ToCoordinate(p.high);
      const double tiny = 1e-3 * (high - low);
      if (x - low < tiny || high - x < tiny) return "a value is on the edge of what is plausible";
    }
    return "";
  }

  size_t FormulaIndex() const {
    size_t i = 0;
    while (i < out_.effects.size() && out_.effects[i].candidate.effect != "unlisted") ++i;
    return i;
  }

  /// The model of the accepted effects but those dropped, fitted.
  ElementFit Without(const std::vector<size_t>& dropped, FreeModel* model) const {
    *model = out_.declared;
    size_t at = model->free.size();
    std::vector<double> start(out_.after.values.begin(),
                              out_.after.values.begin() + static_cast<long>(at));
    for (size_t i = 0; i < out_.effects.size(); ++i) {
      const Candidate& c = out_.effects[i].candidate;
      if (std::find(dropped.begin(), dropped.end(), i) == dropped.end()) {
        *model = WithCandidate(*model, c);
        for (size_t k = 0; k < c.free.size(); ++k) start.push_back(out_.after.values[at + k]);
      }
      at += c.free.size();
    }
    return problem_.Fit(*model, start, 15);
  }

  void DropSuperfluous() {
    for (size_t i = 0; i < out_.effects.size() && !cancelled_;) {
      FreeModel model;
      const ElementFit rest = Without({i}, &model);
      if (!rest.ok) return;
      const ElementEvidence e = CompareFits(rest, out_.after);
      if (e.delta_bic >= options_.min_delta_bic && e.cross_validation_gain > 0 &&
          e.estimation_gain >= options_.min_gain) {
        out_.effects[i++].evidence = e;
        continue;
      }
      search::Withdraw(out_.effects[i].candidate.effect, "superfluous beside the later ones",
                       &out_.candidates);
      out_.effects.erase(out_.effects.begin() + static_cast<long>(i));
      out_.corrected = model, out_.after = rest;
      i = 0;
    }
  }

  /// Looks for a formula on top of `model`. `against`: the effect it must beat (else: nothing).
  bool TryFormula(const FreeModel& model, const ElementFit& fit,
                  const AcceptedElementEffect* against) {
    FormulaData data;
    data.residual = fit.residual;
    data.jacobian = fit.jacobian;
    Result<FormulaPlaces> places = PlacesOf(problem_.data(), problem_.Params(model, fit.values));
    if (!places.ok()) return false;
    data.places = std::move(places.value());
    data.column = [&](const auto& full) { return problem_.Column(full); };
    data.independent = [&](const Eigen::VectorXd& r) { return problem_.Independent(r); };
    data.has_pressure = problem_.data().has_pressure;
    data.has_temperature = problem_.data().has_temperature;
    const FoundFormula found = SearchFormula(data, {.threshold = options_.min_delta_bic});
    if (found.empty()) return false;
    const Candidate candidate = search::FormulaCandidate(found, 1e3 * out_.sizes.friction_N);
    if (against != nullptr && candidate.free.size() > against->candidate.free.size() + 1) {
      return false;
    }
    const FreeModel whole = WithCandidate(model, candidate);
    std::vector<double> start = fit.values;
    start.insert(start.end(), candidate.starts[0].begin(), candidate.starts[0].end());
    const ElementFit with = problem_.Fit(whole, start, 15);
    if (!with.ok) return false;
    const ElementEvidence e = CompareFits(fit, with);
    const bool good = e.delta_bic >= options_.min_delta_bic && e.cross_validation_gain > 0 &&
                      e.estimation_gain >= options_.min_gain;
    if (against != nullptr) {
      const ElementEvidence better = CompareFits(out_.after, with);
      if (!good || better.delta_bic < options_.min_delta_bic || better.estimation_gain <= 0) {
        return false;
      }
      const std::string name = against->candidate.effect;
      search::Withdraw(name, "a formula says it better", &out_.candidates);
      std::erase_if(out_.effects, [&](const auto& accepted) {
        return accepted.candidate.effect == name || accepted.candidate.effect == "unlisted";
      });
    }
    out_.candidates.push_back(
        {"unlisted", found.text, 0, e, good ? "accepted" : "not significant"});
    if (!good) return false;
    out_.effects.push_back({candidate, e, {}});
    out_.corrected = whole, out_.after = with, out_.formula = found;
    return true;
  }

  ElementProblem& problem_;
  const ElementSearchOptions options_;
  search::ThreadBudget threads_;
  const ElementProgress progress_;
  ElementIdentification out_;
  std::mutex mutex_;
  std::atomic<bool> cancelled_{false};
  double share_ = 0;
};

}  // namespace

Result<ElementIdentification> IdentifyElement(ElementProblem* problem,
                                              const hydraulics::PhsParams& declared,
                                              const std::vector<std::string>& free,
                                              const ElementSearchOptions& options,
                                              const ElementProgress& progress) {
  Search search(problem, options, progress);
  if (Status s = search.FitDeclared(declared, free); !s.ok()) return s.error();
  search.Select();
  search.FindFormula();
  return search.Finish();
}

}  // namespace phs::identify::element
