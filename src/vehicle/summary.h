// summary.json and compare.json: the numbers that scripts read (docs/results.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "vehicle/run_summary.h"

namespace phs::vehicle {

/// summary.json of one run: status, steady curve, whole run, moment budget.
nlohmann::ordered_json SummaryJson(const RunSummary& summary);
/// `steady_curve` of summary.json.
nlohmann::ordered_json SteadyCurveJson(const SteadyMeans& means);

/// compare.json: every summary, ratios of the same numbers for each ordered pair, scenario, track.
nlohmann::ordered_json Compare(
    const std::vector<std::pair<std::string, nlohmann::ordered_json>>& summaries,
    const Scenario& scenario, const rail::Track& track);

/// Scenario and track as they were used, for reports.
nlohmann::ordered_json DescribeScenario(const Scenario& scenario);
nlohmann::ordered_json DescribeTrack(const rail::Track& track);

}  // namespace phs::vehicle
