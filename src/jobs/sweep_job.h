// Many runs of one scenario on this machine: `phs sweep`, phs.sweep in Python.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "jobs/watch.h"
#include "sweep/run_case.h"
#include "sweep/study.h"
#include "sweep/sweep.h"

namespace phs::jobs {

struct SweepRequest {
  std::string out;         ///< result directory
  int workers = 0;         ///< processes; 0: one per core
  bool resume = false;     ///< go on with what was stopped or killed
  bool overwrite = false;  ///< a former result and an unfinished sweep may go
};

struct Sweep {
  bool all = false;           ///< false: stopped; what is finished is kept in DIR.unfinished
  bool was_finished = false;  ///< asked to go on, and there was nothing left to do
  int done = 0;               ///< runs with a record
  int ok = 0;                 ///< of these, those that ended well
  std::vector<sweep::RunRecord> records;  ///< in order of the runs; none if it was finished before
};

/// Makes all missing runs with worker processes and writes the result directory. Refused: a search
/// for the best design. @pre this process has no other threads (workers are forked)
Result<Sweep> MakeSweep(const sweep::Study& study, const SweepRequest& request, const Watch& watch);

/// One per core where none are asked for.
int NumWorkers(int asked);

/// `error` of work whose finished runs are kept, with the way to go on.
Error KeptUnfinished(Error error);

/// Tables and report of a sweep whose runs are all made, put into place.
Result<std::vector<sweep::RunRecord>> WriteSweep(const sweep::Study& study, sweep::WorkDir* work);

/// What a finished sweep's table says: runs and those that ended well.
Result<Sweep> ReadFinished(const std::string& dir);

int CountOk(const std::vector<sweep::RunRecord>& records);

}  // namespace phs::jobs
