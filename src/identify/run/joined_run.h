// Several measured runs identified as one (joined_forward.h): from runs to results.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identify/models/joined_forward.h"
#include "identify/run/driven_run.h"

namespace phs::identify::search {

/// One run: what was measured and how it is modelled.
struct RunToJoin {
  const measurement::FitData& data;
  JoinedPart part;
};

/// Writes the corrected model of run `run`, counted from 0, as `file`.
using WriteRunModel = std::function<Status(size_t run, const std::string& file,
                                           const hydraulics::PhsParams& corrected)>;

/// Numbers with one value for all runs: those that the manifest names or, where the runs have no
/// models of their own, all.
std::vector<std::string> SharedNumbers(const measurement::Manifest& manifest,
                                       const JoinedPart& first);

/// The loop and its results. Models: model.yaml of the first run, model_2.yaml … where the runs
/// have models of their own.
Result<IdentifyOutcome> SearchJoined(const measurement::Manifest& manifest,
                                     const std::vector<RunToJoin>& runs,
                                     const SearchOptions& options, const Progress& progress,
                                     const WriteRunModel& write, const ResultDir& dir);

}  // namespace phs::identify::search
