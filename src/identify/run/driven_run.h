// From a record and a model to results, for rigs and bogies alike.
#pragma once

#include <functional>

#include "base/result.h"
#include "base/result_dir.h"
#include "identify/result/motion_share.h"
#include "identify/result/outcome.h"
#include "identify/result/result_json.h"
#include "identify/select/effect_search.h"
#include "measurement/fit_data.h"
#include "measurement/manifest.h"

namespace phs::identify::search {

/// Columns of the data on their clock: the driving motion and `outputs`.
Status WriteChannels(const ResultDir& dir, const std::string& file,
                     const measurement::FitData& data, const Channels& outputs);
/// measured.csv: what was fitted to, after all mending.
Status WriteMeasured(const ResultDir& dir, const measurement::FitData& data);
/// First part of result.json: what was asked and what the data are like.
Json Head(const measurement::Manifest& manifest, const measurement::FitData& data);

/// By how much (standard deviation) predictions over the whole record are uncertain though the
/// model be right: through what drives it, and by what its theory leaves open.
Result<Channels> KnownErrors(const ForwardModel& forward, const hydraulics::PhsParams& params);

/// Of the residual of whole-record predictions over noise and known errors, per channel;
/// window [s].
std::vector<LeftOver> OverNoise(const measurement::FitData& data, const Channels& uncertain,
                                const Channels& predicted, const std::array<double, 2>& window);

/// Writes the corrected model in the form of the declared one.
using WriteModel = std::function<Status(const hydraulics::PhsParams& corrected)>;
/// The loop and its results, whatever the model is.
Result<IdentifyOutcome> SearchAndWrite(const measurement::Manifest& manifest,
                                       const measurement::FitData& data,
                                       const hydraulics::PhsParams& declared, FitProblem* problem,
                                       const SearchOptions& options, const Progress& progress,
                                       const WriteModel& write_model, const ResultDir& dir);

}  // namespace phs::identify::search
