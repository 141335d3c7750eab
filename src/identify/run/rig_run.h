// A whole run of `phs rig`: a declared model driven by measured or generated motion, beside what
// was measured (docs/rig.md). No parameter is fitted.
#pragma once

#include "base/result.h"
#include "base/result_dir.h"
#include "identify/result/outcome.h"
#include "measurement/manifest.h"

namespace phs::identify {

/// Writes result.json and predicted.csv (and measured.csv: the data as used) into `dir`; neither
/// report nor commit. Errors: what the manifest, the data or the model say wrongly; a driven stroke
/// beyond the end stop; a prediction that is no number.
Result<RigOutcome> RunRig(const measurement::Manifest& manifest, const ResultDir& dir);

}  // namespace phs::identify
