#include "identify/select/identification.h"

#include <algorithm>

#include "base/words.h"
#include "effects/unlisted.h"
#include "identify/fit/accept.h"

namespace phs::identify::search {

std::vector<double> ValuesWithout(const Identification& found, size_t dropped, FreeModel* model) {
  *model = found.declared;
  const std::vector<double>& all = found.after.values;
  size_t at = model->free.size();
  std::vector<double> values(all.begin(), all.begin() + static_cast<long>(at));
  for (size_t i = 0; i < found.effects.size(); ++i) {
    const Candidate& c = found.effects[i].candidate;
    if (i != dropped) {
      *model = WithCandidate(*model, c);
      for (size_t k = 0; k < c.free.size(); ++k) values.push_back(all[at + k]);
    }
    at += c.free.size();
  }
  return values;
}

bool IsToldInTheEnd(const Identification& found, size_t effect) {
  const Candidate& candidate = found.effects[effect].candidate;
  if (candidate.effect == effects::UnlistedInfo().name) return true;
  size_t base = found.declared.free.size();
  for (size_t i = 0; i < effect; ++i) base += found.effects[i].candidate.free.size();
  return IsThere(candidate, found.after, base);
}

namespace {

void TakeOut(size_t number, FreeModel* model, FitResult* fit) {
  const auto at = static_cast<long>(number);
  model->free.erase(model->free.begin() + at);
  fit->values.erase(fit->values.begin() + at);
  if (fit->half_95.size() > number) fit->half_95.erase(fit->half_95.begin() + at);
  const Eigen::Index behind = fit->slopes.cols() - at - 1;
  if (behind < 0) return;
  fit->slopes.middleCols(at, behind) = fit->slopes.rightCols(behind).eval();
  fit->slopes.conservativeResize(Eigen::NoChange, fit->slopes.cols() - 1);
}

}  // namespace

void KeepCore(Identification* found) {
  Candidate& last = found->effects.back().candidate;
  const size_t options = last.free.size() - last.none.size();
  last.free.resize(last.none.size());
  found->corrected.free.resize(found->corrected.free.size() - options);
  found->after.values.resize(found->after.values.size() - options);
}

bool TakeOutEdges(Identification* found) {
  const size_t before = found->after.values.size();
  size_t base = found->declared.free.size();
  for (AcceptedEffect& effect : found->effects) {
    Candidate& form = effect.candidate;
    const bool listed = form.effect != effects::UnlistedInfo().name;
    for (size_t k = form.free.size(); listed && k-- > form.none.size();) {
      if (!IsAtEnd(form.free[k], found->after.values[base + k])) continue;
      form.free.erase(form.free.begin() + static_cast<long>(k));
      TakeOut(base + k, &found->corrected, &found->after);
    }
    base += form.free.size();
  }
  return found->after.values.size() < before;
}

void UpdateRecords(Identification* found) {
  for (AcceptedEffect& effect : found->effects) {
    std::erase_if(effect.confusable_with, [&](const std::string& name) {
      return std::any_of(found->effects.begin(), found->effects.end(), [&](const auto& other) {
        return NameBeside(other.candidate, effect.candidate) == name;
      });
    });
    std::erase_if(effect.rivals, [&](const Rival& rival) {
      return std::find(effect.confusable_with.begin(), effect.confusable_with.end(),
                       NameBeside(rival.form, effect.candidate)) == effect.confusable_with.end();
    });
    for (CandidateRecord& record : found->candidates) {
      if (record.effect != effect.candidate.effect || record.verdict != kAccepted) continue;
      record.evidence = effect.evidence;
      if (!effect.candidate.params.formula.empty()) continue;
      record.variant = VariantName(effect.candidate);
    }
  }
  std::stable_sort(found->effects.begin(), found->effects.end(), [](const auto& a, const auto& b) {
    return a.evidence.delta_bic > b.evidence.delta_bic;
  });
}

std::string NameBesideRivals(const AcceptedEffect& effect) {
  const std::string& name = effect.candidate.effect;
  const bool elsewhere =
      std::any_of(effect.confusable_with.begin(), effect.confusable_with.end(),
                  [&](const std::string& rival) { return rival.starts_with(name + " on "); });
  return elsewhere ? name + " on " + JoinWords(effect.candidate.params.targets) : name;
}

}  // namespace phs::identify::search
