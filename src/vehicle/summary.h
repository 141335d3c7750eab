// The numbers that scripts read, from a run's recorded channels.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "vehicle/simulation.h"

namespace phs::vehicle {

/// summary.json of one run: status, steady curve, whole run, moment budget (docs/results.md).
/// `steady_curve` is the mean over the last third of the first circular arc (of the whole track if
/// it has none); "outer" is the high rail of that curve, the left one on straight track.
nlohmann::ordered_json Summarise(const Simulation& simulation, const RunOutcome& run);

/// compare.json: every summary, ratios of the same numbers for each ordered pair, scenario, track.
nlohmann::ordered_json Compare(
    const std::vector<std::pair<std::string, nlohmann::ordered_json>>& summaries,
    const Scenario& scenario, const rail::Track& track);

/// Scenario and track as they were used, for reports.
nlohmann::ordered_json DescribeScenario(const Scenario& scenario);
nlohmann::ordered_json DescribeTrack(const rail::Track& track);

}  // namespace phs::vehicle
