#include "sweep/slurm_task.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/local_folder.h"
#include "base/numbers.h"
#include "sweep/slurm_batches.h"

namespace phs::sweep {
namespace {

/// A count in Slurm's environment, or `otherwise`.
int FromEnvironment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  const auto number = ParseNumber(text == nullptr ? "" : text);
  return number ? static_cast<int>(*number) : otherwise;
}

}  // namespace

Result<bool> RunSlurmTask(const Study& study, const std::string& batch, WorkDir* work,
                          const Progress& progress) {
  const auto tasks = ReadBatch(batch);
  if (!tasks.ok()) return tasks.error();
  const int index = FromEnvironment("SLURM_ARRAY_TASK_ID", -1);
  const int count = static_cast<int>(tasks.value().size());
  if (index < 0 || index >= count) {
    return Error{"SLURM_ARRAY_TASK_ID", "names no line of " + batch,
                 fmt::format("0 … {}", count - 1), "started by phs sweep --engine slurm"};
  }
  Runs missing;
  for (int run : tasks.value()[static_cast<std::size_t>(index)]) {
    if (run >= 0 && run < study.num_runs() && !ReadRecord(study, work->path(), run)) {
      missing.push_back(run);
    }
  }
  const LocalFolder scratch;
  if (Status s = scratch.status(); !s.ok()) return s.error();
  return MakeRuns(study, missing, std::max(1, FromEnvironment("SLURM_CPUS_PER_TASK", 1)),
                  scratch.path(), work, progress);
}

}  // namespace phs::sweep
