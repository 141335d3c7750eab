// Rigs driven by a measured motion (cylinder, quarter, full, element): from data and declared model
// to results.
#pragma once

#include "identify/identify_run.h"
#include "identify/manifest.h"

namespace phs::identify::search {

/// Identification; see RunIdentify.
Result<IdentifyOutcome> IdentifyDriven(const Manifest& manifest, const SearchOptions& options,
                                       const Progress& progress, const ResultDir& dir);

}  // namespace phs::identify::search
