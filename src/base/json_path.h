// Numbers in a result file by their path: keys joined by dots, entries of lists by their `name`:
//   run.T_gamma_total_J, steady_curve.wheelsets.lead.angle_of_attack_rad
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs {

/// JSON knows no infinity and nothing that is not a number: null.
inline nlohmann::ordered_json NumberOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// What stands at `path`; nullptr if nothing does.
const nlohmann::ordered_json* FindPath(const nlohmann::ordered_json& document,
                                       const std::string& path);

/// Paths of all numbers, and of places for numbers that this run has not (null).
std::vector<std::string> NumberPaths(const nlohmann::ordered_json& document);

/// The number at `path`; NaN where the place is empty (null). The error names the nearest path.
Result<double> NumberAt(const nlohmann::ordered_json& document, const std::string& path);

}  // namespace phs
