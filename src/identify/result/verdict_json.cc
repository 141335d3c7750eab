// The verdict as it stands in result.json, from what was found.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "identify/fit/accept.h"
#include "identify/result/result_json.h"
#include "identify/select/own_form.h"

namespace phs::identify::search {

namespace {

/// Numbers of an effect's form, but for its amounts, that ended at an end of their range. What an
/// amount may do there decides accept.h.
std::vector<std::string> NumbersAtEnd(const Identification& found, const Candidate& form) {
  std::vector<std::string> out;
  for (auto k = static_cast<size_t>(form.mains); k < form.free.size(); ++k) {
    const FreeParameter& p = form.free[k];
    const auto& all = found.corrected.free;
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const FreeParameter& other) { return other.name == p.name; });
    if (at == all.end()) continue;
    const double value = found.after.values[static_cast<size_t>(at - all.begin())];
    if (!IsAtEnd(p, value)) continue;
    out.push_back(fmt::format("{} ({:.3g})", p.name.substr(p.name.rfind('.') + 1), value));
  }
  return out;
}

}  // namespace

std::vector<NamedEffect> NamedEffects(const Identification& found) {
  std::vector<NamedEffect> out;
  const std::optional<size_t> formed = HasOwnForm(found);
  for (size_t i = 0; i < found.effects.size(); ++i) {
    const AcceptedEffect& effect = found.effects[i];
    if (formed && IsFormula(effect)) continue;
    out.push_back({NameBesideRivals(effect), effect.confusable_with, effect.special_case_of});
    out.back().at_end = NumbersAtEnd(found, effect.candidate);
    if (formed == i) out.back().own_form = found.formula.text;
  }
  return out;
}

std::optional<BeyondRange> WouldExplain(const Identification& found) {
  const CandidateRecord* best = nullptr;
  int last = 0;
  for (const CandidateRecord& record : found.candidates) last = std::max(last, record.round);
  for (const CandidateRecord& record : found.candidates) {
    if (record.round != last) continue;
    if (record.verdict == kAccepted) return std::nullopt;  // it was tried before this one came
    if (record.at_end.empty()) continue;
    const bool more = best == nullptr || record.evidence.delta_bic > best->evidence.delta_bic;
    if (more) best = &record;
  }
  if (best == nullptr) return std::nullopt;
  return BeyondRange{best->effect, best->at_end, best->evidence.best_channel, best->evidence.share};
}

std::vector<FittedNumber> FittedNumbers(const Identification& found) {
  constexpr double kEdge = 1e-3;  // of the range
  std::vector<FittedNumber> out;
  for (size_t i = 0; i < found.declared.free.size(); ++i) {
    const FreeParameter& p = found.declared.free[i];
    const double at = p.ToCoordinate(found.after.values[i]);
    const double low = p.ToCoordinate(p.low), high = p.ToCoordinate(p.high);
    // Where its interval holds what is declared the record does not tell it, wherever it ends.
    const auto& half = found.after.half_95;
    const bool told = i >= half.size() || std::abs(p.ToCoordinate(p.start) - at) > half[i];
    const bool edge = told && std::min(at - low, high - at) < kEdge * (high - low);
    out.push_back({p.name, p.logarithmic ? p.start : 0, found.after.values[i], edge, told});
  }
  return out;
}

void PutVerdict(const VerdictFacts& facts, Json* result) {
  const Verdict verdict = Judge(facts);
  (*result)["verdict"] = verdict.word;
  (*result)["verdict_text"] = VerdictSentence(verdict, facts);
  (*result)["reasons"] = verdict.reasons;
}

std::string VerdictLines(const Json& result) {
  std::string out = "verdict: " + result["verdict_text"].get<std::string>() + "\n";
  for (const Json& reason : result["reasons"]) out += "  " + reason.get<std::string>() + "\n";
  return out;
}

}  // namespace phs::identify::search
