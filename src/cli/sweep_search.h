// phs sweep of a study with a block `optimise:`.
#pragma once

#include <string>

#include "cli/verbs.h"
#include "sweep/study.h"

namespace phs::cli {

/// Searches, writes the result directory and prints it; the exit code.
int FindBestDesign(sweep::Study study, int workers, const std::string& out, bool resume,
                   const CommonOptions& common);

}  // namespace phs::cli
