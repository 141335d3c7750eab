// The side of a Slurm sweep that runs on the machines of the cluster (slurm_engine.h starts it).
#pragma once

#include <string>

#include "base/result.h"
#include "sweep/sweep.h"

namespace phs::sweep {

/// In a task: makes the runs of line SLURM_ARRAY_TASK_ID of `batch` that have no record yet.
Result<bool> RunSlurmTask(const Study& study, const std::string& batch, WorkDir* work,
                          const Progress& progress);

}  // namespace phs::sweep
