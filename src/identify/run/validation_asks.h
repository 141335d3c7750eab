// What the validation windows of a bench record would ask for beyond the corrected model: what that
// record excites and the estimation record did not. A diagnosis only, no part of the model.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "identify/models/bench_forward.h"
#include "identify/select/effect_search.h"
#include "identify/select/identification.h"

namespace phs::identify::element {

struct Asked {
  search::Identification found;   ///< in the validation windows
  std::vector<double> estimated;  ///< the same numbers as the estimation windows have them
  std::optional<double> relative_percent_refitted, relative_percent_with_effects;
};

/// `params`: the corrected model, `fit` its fit. Nothing where it cannot be asked.
std::optional<Asked> AskValidation(const ElementData& data, const search::FreeModel& corrected,
                                   const search::FitResult& fit,
                                   const hydraulics::PhsParams& params,
                                   const search::SearchOptions& options);
/// `validation_asks_for` of result.json.
nlohmann::ordered_json AskedJson(const std::optional<Asked>& asked);
/// A sentence for each effect that the validation record alone asks for.
void AddAsked(const std::optional<Asked>& asked, nlohmann::ordered_json* tests);

}  // namespace phs::identify::element
