// Slurm's own commands (sbatch, squeue, scontrol, sinfo) as functions. What they say is a hint for
// the engine; whether a run was made is decided by its record alone (slurm_engine.h).
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace phs::sweep {

/// What a job array asks of Slurm.
struct ArrayRequest {
  std::string script;                ///< path of the batch script; it reads SLURM_ARRAY_TASK_ID
  std::string argument;              ///< of the script
  std::string name;                  ///< of the job
  std::string log_folder;            ///< JOB_TASK.log goes there
  int tasks = 1;                     ///< indices 0 … tasks - 1
  std::string partition;             ///< empty: Slurm's default
  int time_min = 0;                  ///< limit of one task [min]; 0: the partition's
  std::vector<std::string> options;  ///< further options of sbatch, as they are
};

/// Task of an array: job id and index.
using SlurmTask = std::pair<std::string, int>;

/// Tasks in one array: indices stay below Slurm's MaxArraySize. Error: Slurm does not answer.
Result<int> MostTasksPerArray();

/// Processors of a partition ("" = all); 1 if Slurm does not tell.
int SlurmProcessors(const std::string& partition);

/// The command as it is run, for plans and messages.
std::string SubmitCommand(const ArrayRequest& request);

/// Submits; returns the job id. Error: what sbatch said.
Result<std::string> Submit(const ArrayRequest& request);

/// States of this user's array tasks that Slurm still knows, finished ones too for a while:
/// "PENDING", "RUNNING", "FAILED" …. Error: Slurm does not answer (nothing is known then).
Result<std::map<SlurmTask, std::string>> TaskStates();

/// Whether a task in this state is over: it will not run again by itself.
bool IsOver(const std::string& state);

/// `text` as one word of a shell command.
std::string ShellWord(const std::string& text);

}  // namespace phs::sweep
