// The standard quantities of a run beside their limits, and wear of the wheels.
#pragma once

#include <string>

#include "cli/curve_table.h"

namespace phs::cli {

/// Of every quantity the wheelset and section nearest to its limit, a column for each bogie; then
/// wear regimes. Empty if no summary holds an assessment (analysis::AssessRun).
std::string AssessmentTable(const NamedSummaries& summaries);

}  // namespace phs::cli
