// The table that `simulate` and `compare` print: one column per bogie.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace phs::cli {

using NamedSummaries = std::vector<std::pair<std::string, nlohmann::ordered_json>>;

/// Steady-curve and whole-run figures, one row each; with several bogies, how the first compares.
std::string CurveTable(const NamedSummaries& summaries);

/// Plain words on what steers the leading axle and what holds it back, from the moment budget.
std::string SteeringBudget(const NamedSummaries& summaries);

}  // namespace phs::cli
