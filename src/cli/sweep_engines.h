// The runs of a sweep as tasks of Slurm.
#pragma once

#include <optional>
#include <string>

#include "sweep/slurm_options.h"
#include "sweep/sweep.h"

namespace CLI {
class App;
}  // namespace CLI

namespace phs::cli {

/// The options of `phs sweep` that only Slurm needs. Negative or empty: as the study says.
struct EngineOptions {
  std::string partition;
  int time_min = -1;
  int chunk = -1;
  int queued_tasks = -1;
  std::vector<std::string> sbatch;
  bool no_wait = false;
  bool plan = false;
  std::string task;  ///< this process is a task: the file with its runs

  /// The study's options with those of the command line over them.
  sweep::SlurmOptions Over(sweep::SlurmOptions options) const;
};

void AddEngineOptions(CLI::App* verb, EngineOptions* options);

/// Makes all missing runs. Nothing: all are made; else the exit code, and the reason is printed.
std::optional<int> MakeRunsOnSlurm(const sweep::Study& study, const sweep::SlurmOptions& options,
                                   sweep::WorkDir* work, bool quiet);

/// What would be submitted, without doing it.
int PrintSlurmPlan(const sweep::Study& study, const sweep::SlurmOptions& options,
                   const std::string& out);

/// This process as a task of an array.
int RunSlurmTask(const sweep::Study& study, const std::string& out, const std::string& batch);

}  // namespace phs::cli
