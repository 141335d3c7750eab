// A whole run of `phs identify`: from a manifest to a result directory
// (docs/identify.md, docs/program.md).
#pragma once

#include <string>

#include "base/result.h"
#include "base/result_dir.h"
#include "identify/result/outcome.h"
#include "identify/select/effect_search.h"

namespace phs::identify::search {

/// Writes result.json, measured.csv (checked and mended), predicted.csv, baseline.csv and
/// model.yaml into `dir` (not the report, not committed). A cancelled run writes nothing.
Result<IdentifyOutcome> RunIdentify(const std::string& manifest_path, const SearchOptions& options,
                                    const Progress& progress, const ResultDir& dir);

}  // namespace phs::identify::search
