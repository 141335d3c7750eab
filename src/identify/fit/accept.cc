#include "identify/fit/accept.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "effects/catalogue.h"

namespace phs::identify::search {
namespace {

constexpr double kEdge = 1e-3;  // of a range: as good as its end (a fit stops this short of it)

bool IsAtHigh(const FreeParameter& p, double value) {
  const double low = p.ToCoordinate(p.low), high = p.ToCoordinate(p.high);
  return high - p.ToCoordinate(value) < kEdge * (high - low);
}

bool IsAtLow(const FreeParameter& p, double value) {
  const double low = p.ToCoordinate(p.low), high = p.ToCoordinate(p.high);
  return p.ToCoordinate(value) - low < kEdge * (high - low);
}

/// Nothing lies outside the interval. Of a logarithmic number the deviation is relative: a half
/// width of 1 is as much as the number itself.
bool ExcludesNone(const FreeParameter& p, double none, double value, double half_95) {
  if (p.logarithmic && none <= 0) return half_95 < 1;
  return std::abs(p.ToCoordinate(value) - p.ToCoordinate(none)) > half_95;
}

}  // namespace

bool IsBeyondChance(const SearchRule& rule, double gain, double tried) {
  const double paid = rule.structures ? 2 * std::log(std::max(1.0, tried)) : 0;
  return gain > paid - 2 * std::log(rule.accept.false_alarms);
}

bool IsAtEnd(const FreeParameter& p, double value) {
  return IsAtHigh(p, value) || IsAtLow(p, value);
}

bool AreTold(const std::vector<FreeParameter>& free, const FitResult& fit, size_t count) {
  for (size_t k = 1; k <= count; ++k) {
    const FreeParameter& p = free[free.size() - k];
    const double value = fit.values[fit.values.size() - k];
    const double half = fit.half_95[fit.half_95.size() - k];
    if (IsAtEnd(p, value)) return false;
    if (2 * half > p.ToCoordinate(p.high) - p.ToCoordinate(p.low)) return false;
  }
  return true;
}

bool IsThere(const Candidate& form, const FitResult& fit, size_t base) {
  bool there = false;
  for (size_t k = 0; k < static_cast<size_t>(form.mains); ++k) {
    const FreeParameter& p = form.free[k];
    const double value = fit.values[base + k];
    if (IsAtHigh(p, value) || (!p.logarithmic && IsAtLow(p, value))) return false;
    if (IsAtLow(p, value)) continue;
    there |= ExcludesNone(p, form.none[k], value, fit.half_95[base + k]);
  }
  return there;
}

std::vector<std::string> AmountsAtEnd(const Candidate& form, const FitResult& fit, size_t base) {
  std::vector<std::string> out;
  for (size_t k = 0; k < static_cast<size_t>(form.mains); ++k) {
    const FreeParameter& p = form.free[k];
    const double value = fit.values[base + k];
    if (!IsAtHigh(p, value) && (p.logarithmic || !IsAtLow(p, value))) continue;
    out.push_back(fmt::format("{} ({:.4g})", p.name.substr(p.name.rfind('.') + 1), value));
  }
  return out;
}

bool IsOfInstrument(const Candidate& form) {
  const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(form.params);
  return info != nullptr && info->family == "instrument";
}

bool Contains(const Candidate& form, const Candidate& other) {
  const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(form.params);
  if (info == nullptr) return false;
  const std::vector<std::string>& parts = info->search.contains;
  return std::find(parts.begin(), parts.end(), other.effect) != parts.end();
}

bool Beats(const FitProblem& problem, const Candidate& form, const FitResult& fit,
           const Candidate& other, const FitResult& other_fit) {
  const double ahead = Criterion(problem, other_fit.score, other_fit.values.size()) -
                       Criterion(problem, fit.score, fit.values.size());
  const SearchRule& rule = problem.rule();
  const auto second = [&rule](const Candidate& a, const Candidate& b) {
    return rule.plain_first && (Contains(a, b) || (IsOfInstrument(a) && !IsOfInstrument(b)));
  };
  if (second(form, other)) return IsBeyondChance(rule, ahead, 1);
  if (second(other, form)) return !IsBeyondChance(rule, -ahead, 1);
  return ahead > 0;
}

std::string Refusal(const SearchRule& rule, const Evidence& evidence, const Candidate& form,
                    const FitResult& fit) {
  if (!IsBeyondChance(rule, evidence.delta_bic, 1)) return "not significant";
  if (rule.cross_validation && evidence.cross_validation_gain <= 0) {
    return "no gain in cross-validation";
  }
  if (evidence.share < rule.accept.least_share) return "explains too little of what is left";
  if (rule.beyond_zero && !IsThere(form, fit, fit.values.size() - form.free.size())) {
    return kNotTold;
  }
  return "";
}

}  // namespace phs::identify::search
