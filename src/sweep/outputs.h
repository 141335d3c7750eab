// Which numbers of a run's summary go into the table of a sweep.
//
// An output is a path in summary.json (docs/results.md), members of lists by their name:
//   steady_curve.wheelsets.lead.angle_of_attack_rad, run.T_gamma_total_J
// Its column is the path without its first part and without list names: lead_angle_of_attack_rad,
// T_gamma_total_J.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.h"

namespace phs::sweep {

/// What an engineer looks at first.
std::vector<std::string> DefaultOutputs();

std::string OutputColumn(const std::string& path);

/// The number at `path`; an error names the nearest member. Not a number (null) is NaN.
Result<double> FindOutput(const nlohmann::ordered_json& summary, const std::string& path);

}  // namespace phs::sweep
