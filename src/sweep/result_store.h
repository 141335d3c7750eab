// The results of a sweep: sweep.csv, and the same as an indexed SQLite file.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "sweep/run_case.h"
#include "sweep/study.h"

namespace phs::sweep {

/// Column names of sweep.csv: run, axes, seed if runs have one of their own, status, outputs,
/// reason.
std::vector<std::string> ColumnNames(const Study& study);

/// One row per run in order of the runs. `records` sorted by run.
Status WriteSweepCsv(const Study& study, const std::vector<RunRecord>& records,
                     const std::string& path);

/// Tables `runs` (columns of sweep.csv, index on run and status), `columns` (name, unit, kind) and
/// `study` (the study file's text).
Status WriteIndex(const Study& study, const std::vector<RunRecord>& records,
                  const std::string& path);

}  // namespace phs::sweep
