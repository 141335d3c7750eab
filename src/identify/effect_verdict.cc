#include "identify/effect_verdict.h"

#include <algorithm>
#include <cmath>

namespace phs::identify::search {

namespace {

/// A precharge is not known better than this [of its value]: one that differs less is the declared.
bool IsDeclaredPrecharge(const FreeModel& model, const FitResult& fit, const Candidate& candidate,
                         size_t base) {
  constexpr double kKnown = 2e-3;
  if (candidate.effect != "accumulator_precharge") return false;
  const auto& targets = candidate.params.targets;
  return std::any_of(model.params.lines.begin(), model.params.lines.end(), [&](const auto& line) {
    const bool meant =
        targets.empty() || std::find(targets.begin(), targets.end(), line.name) != targets.end();
    return meant && line.accumulator.volume_m3 > 0 &&
           std::abs(fit.values[base] / line.accumulator_precharge_Pa - 1) < kKnown;
  });
}

/// `base`: where the candidate's numbers begin.
bool IsOnBound(const FreeModel& model, const FitResult& fit, const Candidate& candidate,
               size_t base) {
  constexpr double kTiny = 1e-3;
  if (IsDeclaredPrecharge(model, fit, candidate, base)) return true;
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

}  // namespace

bool OnBound(const FreeModel& model, const FitResult& fit, const Candidate& candidate) {
  return IsOnBound(model, fit, candidate, model.free.size() - candidate.free.size());
}

bool AnyOnBound(const FreeModel& model, const FitResult& fit, size_t declared,
                const std::vector<AcceptedEffect>& effects) {
  size_t base = declared;
  for (const AcceptedEffect& effect : effects) {
    if (IsOnBound(model, fit, effect.candidate, base)) return true;
    base += effect.candidate.free.size();
  }
  return false;
}

bool IsSettled(const FreeModel& model, const FitResult& fit, const Candidate& candidate) {
  constexpr double kAny = 0.25;  // of its range
  const size_t base = model.free.size() - candidate.free.size();
  for (size_t i = base; i < base + static_cast<size_t>(candidate.mains); ++i) {
    const FreeParameter& p = model.free[i];
    if (fit.half_95[i] > kAny * (p.ToCoordinate(p.high) - p.ToCoordinate(p.low))) return false;
  }
  return true;
}

namespace {

// Of one channel's residual: enough whatever the others show. The first effect may take half as
// much where the channel is left with its noise: what the uncertain motion makes of friction about
// standstill is an upper bound, so that a residual may hide below it.
constexpr double kMuch = 0.5, kMuchToNoise = 0.25;
// Of a second effect with strong evidence: of one channel's residual, and of what a pressure still
// shows beyond its noise.
constexpr double kStrong = 100, kMuchWhereStrong = 0.35, kMuchOfPressure = 0.6;

std::string Significance(const Evidence& e, const SearchOptions& options) {
  constexpr double kWorse = -50;  // whitened: what is fast gets worse for the sake of what is slow
  if (e.delta_bic < options.min_delta_bic) return "not significant";
  if (e.cross_validation_gain <= 0) return "no gain in cross-validation";
  if (e.whitened_bic < kWorse) return "makes the fast part of the residual worse";
  return "";
}

}  // namespace

std::string Verdict(const Evidence& e, bool on_bound, bool first, const SearchOptions& options) {
  const bool sure = !first && e.settled && e.delta_bic >= kStrong;
  const bool strong = sure && e.cross_validation_gain > 0.7 * e.estimation_gain;
  const double much = strong ? kMuchWhereStrong : kMuch;
  if (std::string no = Significance(e, options); !no.empty()) return no;
  if (sure && !on_bound && e.pressure_removed >= kMuchOfPressure) return "";
  if (e.estimation_gain < options.min_gain && e.best_channel_gain < options.min_channel_gain) {
    return "gain too small";
  }
  if (on_bound) return kNotPlausible;
  const double least = first ? options.min_first_removed : options.min_excess_removed;
  const bool to_noise = first && e.best_channel_left <= 1;
  if (e.excess_removed < least && e.best_channel_gain < (to_noise ? kMuchToNoise : much)) {
    return "explains too little of what is left";
  }
  return "";
}

std::string FormulaVerdict(const Evidence& e, double gain, bool first,
                           const SearchOptions& options) {
  if (std::string no = Significance(e, options); !no.empty()) return no;
  const double least = first ? options.min_channel_gain : options.min_formula_gain;
  if (gain < least || e.excess_removed < options.min_first_removed) {
    return "explains too little of what is left";
  }
  return "";
}

void NoteConfusable(const FitProblem& problem, const FitResult& best, const FitResult& other,
                    const std::string& effect, const SearchOptions& options,
                    AcceptedEffect* accepted) {
  const Evidence e = Compare(problem, other, best);
  if (e.delta_bic > options.min_delta_bic && e.estimation_gain > options.margin) return;
  auto& names = accepted->confusable_with;
  if (std::find(names.begin(), names.end(), effect) == names.end()) names.push_back(effect);
}

}  // namespace phs::identify::search
