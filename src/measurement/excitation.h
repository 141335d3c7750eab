// Does the driving motion move and turn in the estimation windows? Without, nothing can be told.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "measurement/rig_data.h"

namespace phs::measurement {

/// Error where channel `input` of the runs together stands still in their estimation windows, or
/// turns fewer than two times by 20 times its noise (0.1 um at least). Runs without such a window
/// do not count; where none has one, nothing is asked.
Status CheckExcitation(const std::vector<const RigRun*>& runs, size_t input);

}  // namespace phs::measurement
