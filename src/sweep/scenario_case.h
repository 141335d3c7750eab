// A run of a study over a scenario: the scenario, its track and its PHS model with the axes' values.
#pragma once

#include <string>

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Writes scenario.yaml, and track.yaml and model.yaml where they differ from the base, into
/// `folder`. Returns the path of scenario.yaml. Errors name the axis.
Result<std::string> WriteScenarioCase(const Study& study, int run, const std::string& folder);

/// It can be read.
Status CheckScenario(const std::string& file);

Result<std::string> FindScenario(const std::string& name);

}  // namespace phs::sweep
