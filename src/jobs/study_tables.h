// What a study's report says of a sweep's table: curves by groups, and how far numbers lie apart.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "base/result.h"
#include "base/table.h"
#include "jobs/design_study.h"

namespace phs::jobs {

/// `{"title", "x", "y", "curves": [{"label", "x": […], "y": […]}]}`, rows whose status is not ok or
/// that have no number left out, each curve in the order of its abscissa.
Result<nlohmann::ordered_json> PlotJson(const StudyPlot& plot, const Table& table);

/// `{"title", "of", "within_factor", "kept": groups that keep it, "groups": [{"name", "runs",
/// "lacking": runs without one of the numbers, "least", "largest", "factor", "kept"}]}`. A group
/// that lacks a number keeps nothing; a number that is not positive makes the factor null.
Result<nlohmann::ordered_json> SpreadJson(const StudySpread& spread, const Table& table);

}  // namespace phs::jobs
