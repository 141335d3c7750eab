// Scenarios as files (docs/scenarios.md).
#pragma once

#include <string>

#include "base/result.h"
#include "vehicle/scenario.h"

namespace phs::vehicle {

/// Paths in the file are looked up from its own folder first, then from the current one. Errors
/// name file:line and key.
Result<Scenario> LoadScenario(const std::string& name_or_path);
/// The scenario `name_or_path` with keys of its file replaced by those of `changes`, a map in YAML
/// or JSON on one line; without a name `changes` is the whole scenario. Paths in `changes` begin in
/// the current folder. Errors name the key.
Result<Scenario> ScenarioWith(const std::string& name_or_path, const std::string& changes);
/// The same form: reading it back gives an equal scenario. Paths are made absolute.
std::string ToYaml(const Scenario& scenario);

}  // namespace phs::vehicle
