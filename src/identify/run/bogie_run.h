// `rig: bogie`: a bogie in a measured curve, identified or only compared (docs/identify_bogie.md).
#pragma once

#include "base/result.h"
#include "base/result_dir.h"
#include "identify/result/outcome.h"
#include "identify/select/effect_search.h"
#include "measurement/manifest.h"

namespace phs::identify::search {

/// Identification; see RunIdentify. Beside its files: model.yaml is the corrected scenario,
/// phs.yaml the PHS model in it.
Result<IdentifyOutcome> IdentifyBogie(const measurement::Manifest& manifest,
                                      const SearchOptions& options, const Progress& progress,
                                      const ResultDir& dir);

/// The declared scenario beside what was measured: result.json, predicted.csv, measured.csv.
Result<IdentifyOutcome> RunBogieRig(const measurement::Manifest& manifest, const ResultDir& dir);

}  // namespace phs::identify::search
