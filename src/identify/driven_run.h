// Rigs driven by a measured motion (cylinder, quarter, full, element): from data and declared model
// to results.
#pragma once

#include <functional>

#include "identify/identify_run.h"
#include "identify/manifest.h"
#include "identify/result_json.h"

namespace phs::identify::search {

/// Columns of the data on their clock: the driving motion and `outputs`.
Status WriteChannels(const ResultDir& dir, const std::string& file, const FitData& data,
                     const Channels& outputs);
/// measured.csv: what was fitted to, after all mending.
Status WriteMeasured(const ResultDir& dir, const FitData& data);
/// First part of result.json: what was asked and what the data are like.
Json Head(const Manifest& manifest, const FitData& data);

/// Writes the corrected model in the form of the declared one.
using WriteModel = std::function<Status(const hydraulics::PhsParams& corrected)>;
/// The loop and its results, whatever the model is.
Result<IdentifyOutcome> SearchAndWrite(const Manifest& manifest,
                                       const hydraulics::PhsParams& declared, FitProblem* problem,
                                       const SearchOptions& options, const Progress& progress,
                                       const WriteModel& write_model, const ResultDir& dir);

/// Identification; see RunIdentify.
Result<IdentifyOutcome> IdentifyDriven(const Manifest& manifest, const SearchOptions& options,
                                       const Progress& progress, const ResultDir& dir);

}  // namespace phs::identify::search
