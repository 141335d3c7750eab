#include "identify/bogie_candidates.h"

#include "effects/catalogue.h"

namespace phs::identify::search {

using hydraulics::EffectForm;
using hydraulics::EffectInfo;
using hydraulics::Places;

std::vector<Candidate> ListBogieCandidates(const hydraulics::PhsParams& params,
                                           const vehicle::DeclaredRunning& declared) {
  std::vector<Candidate> out;
  for (const vehicle::RunningEffect& row : vehicle::RunningEffects()) {
    if (IsIn(params, row.info.name)) continue;
    FormScale scale;
    if (row.declared != nullptr) scale.declared = row.declared(declared);
    for (const EffectForm& form : row.info.search.bogie) {
      out.push_back(MakeCandidate(row.info, form, scale));
    }
  }
  for (const EffectInfo& info : effects::Catalogue().effects()) {
    if (IsIn(params, info.name)) continue;
    for (const EffectForm& form : info.search.bogie) {
      Candidate candidate = MakeCandidate(info, form, {});
      if (form.places == Places::kAll) {
        out.push_back(std::move(candidate));
        continue;
      }
      for (const auto& line : params.lines) {
        candidate.params.targets = {line.name};
        out.push_back(candidate);
      }
    }
  }
  return out;
}

std::vector<std::string> BogieCandidateNames() {
  std::vector<std::string> names;
  const auto add = [&](const EffectInfo& info) {
    if (!info.search.bogie.empty()) names.push_back(info.name);
  };
  for (const vehicle::RunningEffect& row : vehicle::RunningEffects()) add(row.info);
  for (const EffectInfo& info : effects::Catalogue().effects()) add(info);
  return names;
}

}  // namespace phs::identify::search
