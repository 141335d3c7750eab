// A run of a study over a rig: its manifest with the axes' values. Numbers of the model stand in it as
// `phs_parameters`, so `phs rig` repeats the run from that one file.
#pragma once

#include <string>

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Writes rig.yaml into `folder` and returns its path. Where an output asks for it and the manifest
/// names none, the manifest of the study is what the run is compared with (`compare_with`). Errors
/// name the axis.
Result<std::string> WriteRigCase(const Study& study, int run, const std::string& folder);

}  // namespace phs::sweep
