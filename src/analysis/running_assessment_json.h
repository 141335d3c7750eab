// `assessment` of summary.json (docs/results.md). `status` is "ok", or "not assessed" with a `reason`.
#pragma once

#include <nlohmann/json.hpp>

#include "analysis/running_assessment.h"

namespace phs::analysis {

nlohmann::ordered_json AssessmentJson(const Assessment& assessment);

}  // namespace phs::analysis
