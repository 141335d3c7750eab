// `phs identify` and `phs rig` for a part on a bench (rig: element): data in, result files out.
//
// Beside what interfaces describe, result.json holds "validation_asks_for": the corrected model's
// numbers fitted anew on the validation windows, and the effects that these windows would ask for
// beyond it. That is a diagnosis: it does not enter the corrected model or its score.
#pragma once

#include "base/result.h"
#include "base/result_dir.h"
#include "identify/result/outcome.h"
#include "identify/select/effect_search.h"
#include "measurement/manifest.h"

namespace phs::identify::element {

/// Writes result.json, measured.csv, predicted.csv, baseline.csv and model.yaml into `dir`.
Result<search::IdentifyOutcome> RunElementIdentify(const measurement::Manifest& manifest,
                                                   const search::SearchOptions& options,
                                                   const search::Progress& progress,
                                                   const ResultDir& dir);
/// The declared model as it is: result.json, measured.csv and predicted.csv.
Result<search::IdentifyOutcome> RunElementRig(const measurement::Manifest& manifest,
                                              const ResultDir& dir);

}  // namespace phs::identify::element
