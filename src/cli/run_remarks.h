// What the program says of its own error and of limits that a run touched, below the table.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "cli/curve_table.h"

namespace phs::cli {

/// What each headline number moves by when the step is halved, a column for each bogie; numbers
/// beyond 2 % are marked and those beyond it that are no headline are named. Empty without
/// --verify. `ratios`: of compare.json, null for one bogie.
std::string DiscretisationTable(const NamedSummaries& summaries,
                                const nlohmann::ordered_json& ratios);

/// Limits of the hydraulics that were passed, and energy errors beyond 0.1 %, a line each.
std::string WarningLines(const NamedSummaries& summaries);

}  // namespace phs::cli
