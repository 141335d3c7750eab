// One run of a study, from its values to its record on disk.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "sweep/study.h"

namespace phs::sweep {

struct RunRecord {
  int run = 0;
  std::string status;  ///< ok | derailed | diverged | error | killed
  std::string reason;
  std::vector<double> outputs;  ///< as Study::outputs; NaN where there is none
};

/// Lays out the run's files in `scratch` (emptied after), simulates, takes the outputs. Bad input
/// is status "error". The record depends on study and run alone; so a disk that is full or fails
/// is an error of the call and no record.
Result<RunRecord> RunCase(const Study& study, int run, const std::string& scratch);

/// The record of a run whose process was lost.
RunRecord KilledRun(const Study& study, int run, const std::string& reason);

/// DIRECTORY/runs/000123.json: written aside and renamed.
std::string RecordPath(const std::string& directory, int run);
Status WriteRecord(const RunRecord& record, const std::string& directory);
/// The record of a run, or nothing if it is absent or cannot be read (it is then made again).
std::optional<RunRecord> ReadRecord(const Study& study, const std::string& directory, int run);

}  // namespace phs::sweep
