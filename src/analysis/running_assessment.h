// What a run means by the standards: every wheelset on every section of its track after EN 14363
// and UIC 518 (en14363.h), ride of the car body, wear regime and rolling contact fatigue of every
// wheel.
//
// A wheelset is assessed on the rows at which it stands on the section itself. Quasi-static values
// belong to full arcs, instability to straight track: its frequency f0 is that of the zero
// crossings of the leading sum of Y in the band 1 … 12 Hz, and is left out where that is not above
// 2 Hz.
#pragma once

#include <nlohmann/json.hpp>

#include "vehicle/simulation.h"

namespace phs::analysis {

/// `assessment` of summary.json (docs/results.md). `status` is "ok", or "not assessed" with a
/// `reason`: recorded too seldom for 20 Hz, a run that went backwards.
nlohmann::ordered_json AssessRun(const vehicle::Simulation& simulation,
                                 const vehicle::RunOutcome& run);

}  // namespace phs::analysis
