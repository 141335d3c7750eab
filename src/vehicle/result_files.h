// What a run leaves on disk.
#pragma once

#include <string>

#include "base/result.h"
#include "vehicle/simulation.h"

namespace phs::vehicle {

/// Writes the recorded channels: `path_stem + ".h5"`, and `+ ".csv"` if asked for.
Status WriteTimeSeries(const RunOutcome& run, const std::string& path_stem, bool csv);

}  // namespace phs::vehicle
