// Whether the outputs that a study asks for exist, before anything runs.
#pragma once

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Every output is a number of some vehicle of the study: of the first run, or of one with another
/// bogie. What a run leaves empty (null) counts. The error names the nearest path.
Status CheckOutputs(const Study& study);

}  // namespace phs::sweep
