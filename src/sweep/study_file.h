// Studies as files (docs/sweep.md).
#pragma once

#include <string>

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Reads a study and lays out its runs. Errors name file:line and key. A first run is laid out and
/// read as far as its files (case_files.h), so that a wrong key shows here.
Result<Study> LoadStudy(const std::string& path);

}  // namespace phs::sweep
