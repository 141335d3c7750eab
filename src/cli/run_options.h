// Options that every verb which runs a vehicle has alike.
#pragma once

#include <string>

#include "rail/creep_conditions.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace phs::cli {

/// --track NAME|FILE; `what` says what is done with it.
CLI::Option* AddTrackOption(CLI::App* verb, std::string* track, const std::string& what);

/// --timestep SECONDS, instead of the scenario's and of the bogie file's.
void AddTimestepOption(CLI::App* verb, double* timestep_s, const std::string& what = "Step");

/// --friction: a coefficient (0.35) or a condition by name (dry, wet, …). Anything else is wrong
/// usage.
void AddFrictionOption(CLI::App* verb, rail::FrictionSettings* friction);

}  // namespace phs::cli
