#include "identify/models/bogie_candidates.h"

#include <algorithm>

#include "effects/catalogue.h"

namespace phs::identify::search {

using hydraulics::EffectForm;
using hydraulics::EffectInfo;
using hydraulics::Places;

namespace {

/// Where an effect may stand in a bogie, by what its row says.
std::vector<std::string> PlacesOf(const EffectInfo& info, const hydraulics::PhsParams& params,
                                  const vehicle::DeclaredRunning& declared) {
  if (info.targets == "boxes") return declared.boxes;
  std::vector<std::string> places;
  if (info.targets == "cylinders") {
    for (const auto& cylinder : params.cylinders) places.push_back(cylinder.name);
  } else {
    for (const auto& line : params.lines) places.push_back(line.name);
  }
  return places;
}

/// One form, in all places or in each alone.
void AddForm(const EffectInfo& info, const EffectForm& form, const FormScale& scale,
             const std::vector<std::string>& places, const std::vector<std::string>& free,
             std::vector<Candidate>* out) {
  Candidate candidate = MakeCandidate(info, form, scale);
  if (form.places == Places::kAll) {
    out->push_back(std::move(candidate));
    return;
  }
  for (const std::string& place : places) {
    const bool known =
        std::any_of(form.beside.begin(), form.beside.end(), [&](const std::string& number) {
          return std::find(free.begin(), free.end(), place + "." + number) != free.end();
        });
    if (known) continue;
    candidate.params.targets = {place};
    out->push_back(candidate);
  }
}

}  // namespace

std::vector<Candidate> ListBogieCandidates(const hydraulics::PhsParams& params,
                                           const std::vector<std::string>& free,
                                           const vehicle::DeclaredRunning& declared) {
  std::vector<Candidate> out;
  const auto add = [&](const EffectInfo& info, const FormScale& scale) {
    if (IsIn(params, info.name) || scale.declared == 0.0) return;
    for (const EffectForm& form : info.search.bogie) {
      AddForm(info, form, scale, PlacesOf(info, params, declared), free, &out);
    }
  };
  for (const vehicle::RunningEffect& row : vehicle::RunningEffects()) {
    FormScale scale;
    if (row.declared != nullptr) scale.declared = row.declared(declared);
    add(row.info, scale);
  }
  for (const EffectInfo& info : effects::Catalogue().effects()) {
    FormScale scale;
    if (info.search.declared != nullptr) scale.declared = info.search.declared(params);
    add(info, scale);
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
