// Rigs driven by a measured motion (cylinder, quarter, full): one run, or several as one.
#pragma once

#include "base/result_dir.h"
#include "identify/result/outcome.h"
#include "identify/select/effect_search.h"
#include "measurement/manifest.h"

namespace phs::identify::search {

/// Identification; see RunIdentify.
Result<IdentifyOutcome> IdentifyDriven(const measurement::Manifest& manifest,
                                       const SearchOptions& options, const Progress& progress,
                                       const ResultDir& dir);

}  // namespace phs::identify::search
