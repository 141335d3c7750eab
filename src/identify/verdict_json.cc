// The verdict as it stands in result.json, from what was found.
#include <algorithm>

#include "identify/own_form.h"
#include "identify/result_json.h"

namespace phs::identify::search {

std::vector<NamedEffect> NamedEffects(const Identification& found) {
  std::vector<NamedEffect> out;
  const std::optional<size_t> formed = HasOwnForm(found);
  for (size_t i = 0; i < found.effects.size(); ++i) {
    const AcceptedEffect& effect = found.effects[i];
    if (formed && IsFormula(effect)) continue;
    out.push_back({effect.candidate.effect, effect.confusable_with, effect.special_case_of});
    if (formed == i) out.back().own_form = found.formula.text;
  }
  return out;
}

std::vector<FittedNumber> FittedNumbers(const Identification& found) {
  constexpr double kEdge = 1e-3;  // of the range
  std::vector<FittedNumber> out;
  for (size_t i = 0; i < found.declared.free.size(); ++i) {
    const FreeParameter& p = found.declared.free[i];
    const double at = p.ToCoordinate(found.after.values[i]);
    const double low = p.ToCoordinate(p.low), high = p.ToCoordinate(p.high);
    const bool edge = std::min(at - low, high - at) < kEdge * (high - low);
    out.push_back({p.name, p.logarithmic ? p.start : 0, found.after.values[i], edge});
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
