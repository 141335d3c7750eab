// Scenarios as files (docs/scenarios.md).
#pragma once

#include <string>

#include "base/result.h"
#include "vehicle/scenario.h"

namespace phs::vehicle {

/// Paths in the file are looked up from its own folder first, then from the current one. Errors
/// name file:line and key.
Result<Scenario> LoadScenario(const std::string& name_or_path);
/// The same form: reading it back gives an equal scenario. Paths are made absolute.
std::string ToYaml(const Scenario& scenario);

}  // namespace phs::vehicle
