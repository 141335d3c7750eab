// Numbers of a finished sweep for --check and --junit, read from its tables.
#pragma once

#include <string>
#include <vector>

#include "analysis/limits.h"
#include "sweep/study.h"

namespace phs::cli {

/// Each run as `run_N` with its status and outputs (by their paths in the study); `sweep` with
/// `runs`, `failed` and the `least`, `median` and `largest` of every output. Of a search `best`
/// alone: objective, constraints and design.
Result<std::vector<analysis::NamedSummary>> NumbersOfSweep(const sweep::Study& study,
                                                           const std::string& dir);

}  // namespace phs::cli
