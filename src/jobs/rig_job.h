// A rig run or identified from its manifest, with the report: `phs rig` and `phs identify`,
// phs.rig and phs.identify in Python.
#pragma once

#include <optional>
#include <string>

#include "base/result_dir.h"
#include "identify/result/outcome.h"
#include "identify/select/effect_search.h"
#include "jobs/watch.h"

namespace phs::jobs {

/// Writes the files of a rig run with their report; not committed. `manifest`: a name or a file.
Result<identify::RigOutcome> RunRig(const std::string& manifest, const ResultDir& dir);

struct Identified {
  identify::search::IdentifyOutcome outcome;
  std::optional<Error> report_fault;  ///< a report that cannot be drawn does not spoil the result
};
/// Writes the files of an identification with their report; not committed. Stopped: `cancelled`,
/// nothing written.
Result<Identified> Identify(const std::string& manifest,
                            const identify::search::SearchOptions& options, const Watch& watch,
                            const ResultDir& dir);

}  // namespace phs::jobs
