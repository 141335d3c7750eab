// phs sweep: many runs of one scenario or rig, resumable, on all cores or a cluster.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/running_statistics.h"
#include "base/data_path.h"
#include "base/origin.h"
#include "base/result_dir.h"
#include "base/table.h"
#include "cli/result_checks.h"
#include "cli/sweep_checks.h"
#include "cli/sweep_engines.h"
#include "cli/sweep_search.h"
#include "cli/verb_table.h"
#include "jobs/sweep_job.h"
#include "sweep/case_files.h"
#include "sweep/output_check.h"
#include "sweep/outputs.h"
#include "sweep/result_store.h"
#include "sweep/study_file.h"
#include "sweep/sweep.h"

namespace phs::cli {
namespace {

using sweep::RunRecord;
using sweep::Study;

struct SweepOptions {
  CommonOptions common;
  ResultChecks checks;
  std::string study;
  int workers = 0;
  bool resume = false;
  int only = -1;
  std::string engine = "local";
  EngineOptions slurm;
};

int Count(const std::vector<RunRecord>& records, const std::string& status) {
  return static_cast<int>(std::count_if(records.begin(), records.end(),
                                        [&](const auto& r) { return r.status == status; }));
}

void PrintOutcome(const Study& study, const std::vector<RunRecord>& records,
                  const std::string& path) {
  fmt::print("{}: {} runs", study.name, records.size());
  for (const char* status : {"ok", "derailed", "diverged", "error", "killed"}) {
    if (const int n = Count(records, status); n > 0) fmt::print(", {} {}", n, status);
  }
  fmt::print("\n\n{:<38}{:>14}{:>14}{:>14}   worst run\n", "output", "least", "median", "largest");
  for (std::size_t i = 0; i < study.outputs.size(); ++i) {
    std::vector<double> values;
    int worst = 0;
    double most = -1;
    for (const RunRecord& r : records) {
      if (r.status != "ok" || !std::isfinite(r.outputs[i])) continue;
      values.push_back(r.outputs[i]);
      if (std::abs(r.outputs[i]) > most) most = std::abs(r.outputs[i]), worst = r.run;
    }
    if (values.empty()) continue;
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    fmt::print("{:<38}{:>14.5g}{:>14.5g}{:>14.5g}   {}\n", sweep::OutputColumns(study.outputs)[i],
               *least, analysis::Percentile(values, 50), *largest, worst);
  }
  int shown = 0;
  for (const RunRecord& r : records) {
    if (r.status == "ok") continue;
    fmt::print("{}run {}: {}: {}\n", shown == 0 ? "\n" : "", r.run, r.status, r.reason);
    if (++shown == 5) break;
  }
  const bool report = std::filesystem::exists(path + "/report.html");
  fmt::print("\nTable: {0}/sweep.csv, {1}\nRepeat a run with all its files: {2} RUN --out DIR\n",
             path,
             report ? "report: " + path + "/report.html"
                    : "no report: it draws outputs over a number that varies",
             ShellLine({"phs", "sweep", study.path, "--only"}));
}

/// The runs as files, and one of them simulated as `phs simulate` would.
int RunOnly(const SweepOptions& options, const Study& study) {
  if (options.only >= study.num_runs()) {
    return BadInput({"--only", fmt::format("the study has no run {}", options.only),
                     fmt::format("0 … {}", study.num_runs() - 1), ""});
  }
  const std::string out =
      options.common.out.empty() ? fmt::format("run_{}", options.only) : options.common.out;
  auto dir = ResultDir::Create(out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  if (Status s =
          sweep::LayOutRun(study, options.only, dir.value().File(""), dir.value().final_path());
      !s.ok()) {
    return BadInput(s.error());
  }
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  fmt::print("run {}:", options.only);
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    fmt::print(" {} = {}", study.axes[i].key,
               study.runs[static_cast<std::size_t>(options.only)][i]);
  }
  const sweep::Subject& subject = *study.CaseOf(options.only).subject;
  fmt::print("\n{}\n",
             ShellLine({"phs", subject.verb, out + "/" + subject.file, "--out", out + "/result"}));
  return kDone;
}

void PrintJson(std::size_t runs, long ok, const std::string& path) {
  const nlohmann::ordered_json json = {{"runs", runs}, {"ok", ok}, {"table", path + "/sweep.csv"}};
  fmt::print("{}\n", json.dump());
}

int Tell(const SweepOptions& options, const Study& study, const std::vector<RunRecord>& records,
         const std::string& out) {
  const int ok = jobs::CountOk(records);
  if (options.common.format == "json") {
    PrintJson(records.size(), ok, out);
  } else {
    PrintOutcome(study, records, out);
  }
  return ok == study.num_runs() ? kDone : kFailed;
}

/// A sweep that was ended after its result stood, asked to go on: the exit code that it had.
int TellFinished(const SweepOptions& options, const Study& study, const std::string& out) {
  const auto made = jobs::ReadFinished(out);
  if (!made.ok()) return BadInput(made.error());
  if (options.common.format == "json") {
    PrintJson(static_cast<std::size_t>(made.value().done), made.value().ok, out);
  } else {
    fmt::print("{}: was finished already\n\nTable: {}/sweep.csv\n", study.name, out);
  }
  if (!study.optimisation) return made.value().ok == made.value().done ? kDone : kFailed;
  const auto optimum = ReadFile(out + "/optimum.json");
  if (!optimum.ok()) return BadInput(optimum.error());
  const auto json = nlohmann::json::parse(optimum.value(), nullptr, false);
  const auto best = json.is_object() ? json.value("best", nlohmann::json()) : nlohmann::json();
  return best.is_object() && best.value("keeps_constraints", false) ? kDone : kFailed;
}

std::string OutOf(const SweepOptions& options, const Study& study) {
  return options.common.out.empty() ? study.name : options.common.out;
}

int RunSearch(const SweepOptions& options, const Study& study) {
  if (options.engine != "local" || options.only >= 0 || options.slurm.plan) {
    return BadInput({options.study, "is a search for the best design", "--workers, --resume, --out",
                     "its runs depend on each other: leave --engine, --only and --plan away"});
  }
  const std::string out = OutOf(options, study);
  if (options.resume && sweep::IsFinished(out, study)) return TellFinished(options, study, out);
  return FindBestDesign(study, options.workers, out, options.resume, options.common);
}

int SweepHere(const SweepOptions& options, const Study& study, const std::string& out) {
  const auto made = [&] {
    ProgressLine progress(study.name, options.common.quiet);
    return jobs::MakeSweep(study,
                           {.out = out,
                            .workers = options.workers,
                            .resume = options.resume,
                            .overwrite = options.common.force},
                           {.progress = [&](double share) { return progress(share); }});
  }();
  if (!made.ok()) return BadInput(made.error());
  if (made.value().was_finished) return TellFinished(options, study, out);
  if (!made.value().all) {
    return Stopped(fmt::format("{} of {} runs are done; --resume continues", made.value().done,
                               study.num_runs()));
  }
  return Tell(options, study, made.value().records, out);
}

int SweepOnSlurm(const SweepOptions& options, const Study& study, const sweep::SlurmOptions& slurm,
                 const std::string& out) {
  if (options.resume && sweep::IsFinished(out, study)) return TellFinished(options, study, out);
  if (!options.resume) {
    if (Status s = sweep::CheckOutputs(study); !s.ok()) return BadInput(s.error());
  }
  auto work = sweep::WorkDir::Open(out, study, options.resume, options.common.force);
  if (!work.ok()) return BadInput(work.error());
  if (const auto code = MakeRunsOnSlurm(study, slurm, &work.value(), options.common.quiet)) {
    return *code;
  }
  const auto records = jobs::WriteSweep(study, &work.value());
  if (!records.ok()) return BadInput(records.error());
  return Tell(options, study, records.value(), out);
}

int MakeSweep(const SweepOptions& options, const Study& study) {
  if (study.optimisation) return RunSearch(options, study);
  if (options.only >= 0) return RunOnly(options, study);
  const std::string out = OutOf(options, study);
  const sweep::SlurmOptions slurm = options.slurm.Over(study.slurm);
  if (!options.slurm.task.empty()) return RunSlurmTask(study, out, options.slurm.task);
  if (options.slurm.plan) return PrintSlurmPlan(study, slurm, out);
  return options.engine == "slurm" ? SweepOnSlurm(options, study, slurm, out)
                                   : SweepHere(options, study, out);
}

int RunSweep(SweepOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  const auto loaded = sweep::LoadStudy(options.study);
  if (!loaded.ok()) return BadInput(loaded.error());
  const Study& study = loaded.value();
  const bool a_part = options.only >= 0 || options.slurm.plan || !options.slurm.task.empty();
  if (options.checks.asked() && a_part) {
    return BadInput({"--check, --junit", "are for a whole sweep", "without --only and --plan", ""});
  }
  const int code = MakeSweep(options, study);
  const std::string out = OutOf(options, study);
  const bool made = sweep::IsFinished(out, study);
  if (!options.checks.asked() || !made || (code != kDone && code != kFailed)) return code;
  auto numbers = NumbersOfSweep(study, out);
  if (!numbers.ok()) return BadInput(numbers.error());
  return options.checks.Conclude(study.name, std::move(numbers).value(), code);
}

}  // namespace

void AddSweep(CLI::App* verb, Action* action) {
  auto options = std::make_shared<SweepOptions>();
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->add_option("study", options->study, "Scenario or rig, axes and design (YAML)")->required();
  verb->add_option("--engine", options->engine, "Where the runs are made")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  verb->add_option("--workers", options->workers, "Worker processes (one per core without it)")
      ->check(CLI::Range(1, 4096));
  AddEngineOptions(verb, &options->slurm);
  verb->add_flag("--resume", options->resume, "Continue what was stopped or killed");
  verb->add_option("--only", options->only, "Lay out one run as files, to be simulated alone")
      ->check(CLI::NonNegativeNumber);
  verb->footer(
      "Exit code 1 when a run did not end well or the disk failed, 130 when it was stopped.");
  verb->callback([=] { *action = [=] { return RunSweep(*options); }; });
}

}  // namespace phs::cli
