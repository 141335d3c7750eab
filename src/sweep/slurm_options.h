// What a study or the command line says about Slurm.
#pragma once

#include <string>
#include <vector>

#include "base/yaml.h"

namespace phs::sweep {

struct SlurmOptions {
  std::string partition;             ///< empty: Slurm's default
  int time_min = 0;                  ///< limit of one task [min]; 0: the partition's
  int chunk = 0;                     ///< runs per task; 0: about four tasks per processor
  int queued_tasks = 1000;           ///< at most so many in Slurm's queue at once
  int attempts = 3;                  ///< a run at work when its task is lost is begun so often
  std::vector<std::string> options;  ///< further options of sbatch ("--account=rail")
  bool wait = true;                  ///< false: submit and return
};

/// Reads the block `slurm:` of a study.
SlurmOptions ReadSlurmOptions(YamlMap map);

}  // namespace phs::sweep
