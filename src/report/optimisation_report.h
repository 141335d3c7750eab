// The report of a search for the best design (phs sweep with a block `optimise:`).
#pragma once

#include <string>

#include "base/result.h"

namespace phs::report {

/// From optimum.json and candidates.csv in `folder`: the best design, the best of each combination
/// of choices with what its constraints say, the objective over each parameter.
Status WriteOptimisationReport(const std::string& folder, const std::string& path);

}  // namespace phs::report
