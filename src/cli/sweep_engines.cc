#include "cli/sweep_engines.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "cli/verbs.h"
#include "jobs/sweep_job.h"
#include "sweep/slurm_engine.h"
#include "sweep/slurm_task.h"

namespace phs::cli {
namespace {

std::size_t CountDone(const sweep::Study& study, const sweep::WorkDir& work) {
  return static_cast<std::size_t>(study.num_runs()) - work.Missing(study, false).size();
}

}  // namespace

sweep::SlurmOptions EngineOptions::Over(sweep::SlurmOptions options) const {
  if (!partition.empty()) options.partition = partition;
  if (time_min >= 0) options.time_min = time_min;
  if (chunk >= 0) options.chunk = chunk;
  if (queued_tasks > 0) options.queued_tasks = queued_tasks;
  options.options.insert(options.options.end(), sbatch.begin(), sbatch.end());
  options.wait = !no_wait;
  return options;
}

void AddEngineOptions(CLI::App* verb, EngineOptions* options) {
  const std::string group = "With --engine slurm (instead of the study's block `slurm:`)";
  verb->add_option("--partition", options->partition, "Partition; Slurm's default without it")
      ->group(group);
  verb->add_option("--task-time", options->time_min, "Time limit of one task, minutes")
      ->check(CLI::Range(1, 1000000))
      ->group(group);
  verb->add_option("--chunk", options->chunk, "Runs per task; about four tasks per processor")
      ->check(CLI::Range(1, 1000000))
      ->group(group);
  verb->add_option("--queued-tasks", options->queued_tasks, "At most so many tasks in the queue")
      ->check(CLI::Range(1, 1000000))
      ->group(group);
  verb->add_option("--sbatch", options->sbatch, "Further option of sbatch, e.g. --sbatch=--qos=low")
      ->group(group);
  verb->add_flag("--no-wait", options->no_wait, "Submit and return; --resume collects")
      ->group(group);
  verb->add_flag("--plan", options->plan, "Say what would be submitted")->group(group);
  verb->add_option("--slurm-task", options->task, "")->group("");
}

std::optional<int> MakeRunsOnSlurm(const sweep::Study& study, const sweep::SlurmOptions& options,
                                   sweep::WorkDir* work, bool quiet) {
  ProgressLine progress(study.name, quiet);
  const auto outcome = sweep::RunOnSlurm(study, options, work, [&](int done, int of) {
    return progress(static_cast<double>(done) / of);
  });
  if (!outcome.ok()) return BadInput(jobs::KeptUnfinished(outcome.error()));
  if (outcome.value().all) return std::nullopt;
  const std::string jobs = fmt::format("{}", fmt::join(outcome.value().jobs, " "));
  fmt::print(stderr,
             "phs: {} of {} runs done; Slurm goes on with job {} (scancel {} ends it); "
             "--engine slurm --resume collects\n",
             CountDone(study, *work), study.num_runs(), jobs, jobs);
  return options.wait ? kFailed : kDone;
}

int PrintSlurmPlan(const sweep::Study& study, const sweep::SlurmOptions& options,
                   const std::string& out) {
  const auto plan = sweep::PlanOnSlurm(study, options, out);
  if (!plan.ok()) return BadInput(plan.error());
  const sweep::SlurmPlan& p = plan.value();
  fmt::print("{}: {} runs in {} tasks of {} runs, {} job array{}\n{}\n", study.name, p.runs,
             p.tasks, p.chunk, p.arrays, p.arrays == 1 ? "" : "s", p.command);
  return kDone;
}

int RunSlurmTask(const sweep::Study& study, const std::string& out, const std::string& batch) {
  auto work = sweep::WorkDir::Join(out, study);
  if (!work.ok()) return BadInput(work.error());
  ProgressLine progress(study.name, true);
  const auto all =
      sweep::RunSlurmTask(study, batch, &work.value(), [&](int, int) { return progress(0.5); });
  if (!all.ok()) return BadInput(all.error());
  return all.value() ? kDone : kFailed;
}

}  // namespace phs::cli
