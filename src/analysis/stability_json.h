// stability.json (docs/stability.md) of a finished analysis.
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/limit_cycle.h"
#include "analysis/stability.h"

namespace phs::analysis {

nlohmann::ordered_json StabilityJson(const vehicle::Simulation& simulation,
                                     const StabilityResult& result);
/// The member "limit_cycle".
nlohmann::ordered_json LimitCycleJson(const LimitCycle& cycle, const LimitCycleOptions& options);

}  // namespace phs::analysis
