// A sweep on a cluster: chunks of runs as tasks of Slurm job arrays.
//
// The working directory lies on a file system that all machines share. A task is `phs sweep STUDY
// --out DIR --slurm-task FILE`: it makes the runs of its line of FILE and leaves their records, as
// a local worker does, so the table has the same bytes. This process plans, submits, waits and
// collects.
//
// Exit codes and states that Slurm reports decide nothing: a run is made when its record is there.
// A task that Slurm no longer runs and that left records missing is lost; what it did not make is
// submitted again. The first run without a record was at work when the task ended: lost `attempts`
// times, it becomes "killed", with Slurm's last state and the last line of the task's log.
//
// DIR.unfinished/slurm: task.sh, batch_NNN.txt (one line of runs per task), jobs.txt (job, batch),
// JOB_TASK.log. From jobs.txt a later --resume takes up the tasks still in the queue.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"
#include "sweep/slurm_options.h"
#include "sweep/sweep.h"

namespace phs::sweep {

/// What would be submitted for the runs that are missing in FINAL_PATH.unfinished.
struct SlurmPlan {
  int runs = 0;
  int chunk = 0;        ///< runs per task
  int tasks = 0;        ///< all of them
  int arrays = 0;       ///< job arrays
  std::string command;  ///< of the first array
};
Result<SlurmPlan> PlanOnSlurm(const Study& study, const SlurmOptions& options,
                              const std::string& final_path);

struct SlurmOutcome {
  bool all = false;               ///< every run has its record
  std::vector<std::string> jobs;  ///< arrays still in the queue if not
};

/// Submits what is missing and waits for it (or not, options.wait). Stopped by `progress`, the jobs
/// stay in the queue. Errors: Slurm does not answer or refuses; no task leaves any result.
Result<SlurmOutcome> RunOnSlurm(const Study& study, const SlurmOptions& options, WorkDir* work,
                                const Progress& progress);

}  // namespace phs::sweep
