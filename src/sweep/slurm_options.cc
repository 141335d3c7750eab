#include "sweep/slurm_options.h"

namespace phs::sweep {

SlurmOptions ReadSlurmOptions(YamlMap map) {
  SlurmOptions o;
  o.partition = map.Text("partition", "");
  o.time_min = map.Integer("time_min", 0, 1000000, o.time_min);
  o.chunk = map.Integer("chunk", 0, 1000000, o.chunk);
  o.queued_tasks = map.Integer("queued_tasks", 1, 1000000, o.queued_tasks);
  o.attempts = map.Integer("attempts", 1, 100, o.attempts);
  o.options = map.Texts("options");
  return o;
}

}  // namespace phs::sweep
