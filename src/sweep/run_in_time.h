// The run in time as an analysis of a study: summary.json with its assessment.
#pragma once

#include <string>
#include <vector>

#include "sweep/analysis_row.h"
#include "vehicle/scenario.h"

namespace phs::sweep {

Result<Analysed> RunInTime(const vehicle::Scenario& scenario);
/// The numbers of a run of two steps, which has the same names; the assessment only where `outputs`
/// ask for it.
Result<Analysed> NamesOfRun(const vehicle::Scenario& scenario,
                            const std::vector<std::string>& outputs);

}  // namespace phs::sweep
