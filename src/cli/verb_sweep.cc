// phs sweep: many runs of one scenario, resumable, on all cores or a cluster.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/data_path.h"
#include "base/result_dir.h"
#include "base/table.h"
#include "cli/sweep_engines.h"
#include "cli/sweep_search.h"
#include "cli/verb_table.h"
#include "report/sweep_report.h"
#include "sweep/case_files.h"
#include "sweep/output_check.h"
#include "sweep/outputs.h"
#include "sweep/result_store.h"
#include "sweep/sensitivity.h"
#include "sweep/study_file.h"
#include "sweep/sweep.h"

namespace phs::cli {
namespace {

using sweep::RunRecord;
using sweep::Study;

struct SweepOptions {
  CommonOptions common;
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
    std::vector<std::pair<double, int>> values;
    for (const RunRecord& r : records) {
      if (r.status == "ok" && std::isfinite(r.outputs[i])) values.emplace_back(r.outputs[i], r.run);
    }
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    const auto worst = std::max_element(values.begin(), values.end(), [](auto a, auto b) {
      return std::abs(a.first) < std::abs(b.first);
    });
    fmt::print("{:<38}{:>14.5g}{:>14.5g}{:>14.5g}   {}\n", sweep::OutputColumns(study.outputs)[i],
               values.front().first, values[values.size() / 2].first, values.back().first,
               worst->second);
  }
  int shown = 0;
  for (const RunRecord& r : records) {
    if (r.status == "ok") continue;
    fmt::print("{}run {}: {}: {}\n", shown == 0 ? "\n" : "", r.run, r.status, r.reason);
    if (++shown == 5) break;
  }
  fmt::print(
      "\nTable: {0}/sweep.csv, report: {0}/report.html\n"
      "Repeat a run with all its files: phs sweep {1} --only RUN --out DIR\n",
      path, study.path);
}

/// Sobol indices of one output, where the design gives them.
void AddIndices(const Study& study, const std::vector<RunRecord>& records, std::size_t output,
                report::SweepReportInput* input) {
  if (study.design != sweep::DesignKind::kSobolIndices) return;
  std::vector<double> values;
  for (const RunRecord& r : records) {
    values.push_back(r.status == "ok" ? r.outputs[output] : std::nan(""));
  }
  const auto indices = sweep::SobolIndices(values, static_cast<int>(study.axes.size()));
  if (indices.empty() || input->parameters.size() != study.axes.size()) return;
  report::OutputIndices of{sweep::OutputColumns(study.outputs)[output], {}, {}, {}, {}};
  for (const sweep::SobolIndex& index : indices) {
    of.first.push_back(index.first);
    of.total.push_back(index.total);
    of.first_error.push_back(index.first_error);
    of.total_error.push_back(index.total_error);
  }
  input->indices.push_back(std::move(of));
}

report::SweepReportInput ReportInput(const Study& study, const std::vector<RunRecord>& records,
                                     const std::string& table) {
  report::SweepReportInput input;
  input.table = table;
  input.study = study.path;
  input.sampled =
      study.design != sweep::DesignKind::kGrid && study.design != sweep::DesignKind::kList;
  for (std::size_t axis = 0; axis < study.axes.size(); ++axis) {
    bool numbers = true, varies = false;
    for (const auto& run : study.runs) {
      numbers &=
          !run[axis].empty() && run[axis].find_first_not_of("+-.eE0123456789") == std::string::npos;
      varies |= run[axis] != study.runs[0][axis];
    }
    if (numbers && varies) input.parameters.push_back(study.axes[axis].column);
  }
  for (std::size_t i = 0; i < study.outputs.size(); ++i) {
    const bool any = std::any_of(records.begin(), records.end(),
                                 [&](const auto& r) { return std::isfinite(r.outputs[i]); });
    if (!any) continue;
    input.outputs.push_back(sweep::OutputColumns(study.outputs)[i]);
    AddIndices(study, records, i, &input);
  }
  return input;
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
  fmt::print("\nphs simulate {}/scenario.yaml --out {}/result\n", out, out);
  return kDone;
}

void PrintJson(std::size_t runs, long ok, const std::string& path) {
  const nlohmann::ordered_json json = {{"runs", runs}, {"ok", ok}, {"table", path + "/sweep.csv"}};
  fmt::print("{}\n", json.dump());
}

int Conclude(const SweepOptions& options, const Study& study, sweep::WorkDir* work) {
  const auto records = sweep::ReadRecords(study, *work);
  auto opened = work->OpenResult();
  if (!opened.ok()) return BadInput(opened.error());
  ResultDir& dir = opened.value();
  if (Status s = sweep::WriteTables(study, records, *work, dir); !s.ok()) {
    return BadInput(s.error());
  }
  const auto input = ReportInput(study, records, dir.File("sweep.csv"));
  if (Count(records, "ok") > 0 && !input.outputs.empty() && !input.parameters.empty()) {
    if (Status s = report::WriteSweepReport(input, dir.File("report.html")); !s.ok()) {
      return BadInput(s.error());
    }
  }
  if (Status s = work->Finish(&dir); !s.ok()) return BadInput(s.error());
  if (options.common.format == "json") {
    PrintJson(records.size(), Count(records, "ok"), work->final_path());
  } else {
    PrintOutcome(study, records, work->final_path());
  }
  return Count(records, "ok") == study.num_runs() ? kDone : kFailed;
}

/// A sweep that was ended after its result stood, asked to go on: the exit code that it had.
int TellFinished(const SweepOptions& options, const Study& study, const std::string& out) {
  const auto table = ReadCsv(out + "/sweep.csv");
  if (!table.ok()) return BadInput(table.error());
  const int at = table.value().Find("status");
  const auto& states = table.value().text[static_cast<std::size_t>(std::max(at, 0))];
  const auto ok = std::count(states.begin(), states.end(), "ok");
  if (options.common.format == "json") {
    PrintJson(states.size(), ok, out);
  } else {
    fmt::print("{}: was finished already\n\nTable: {}/sweep.csv\n", study.name, out);
  }
  if (!study.optimisation) return ok == static_cast<long>(states.size()) ? kDone : kFailed;
  const auto optimum = ReadFile(out + "/optimum.json");
  if (!optimum.ok()) return BadInput(optimum.error());
  const auto json = nlohmann::json::parse(optimum.value(), nullptr, false);
  const auto best = json.is_object() ? json.value("best", nlohmann::json()) : nlohmann::json();
  return best.is_object() && best.value("keeps_constraints", false) ? kDone : kFailed;
}

int RunSearch(const SweepOptions& options, const Study& study) {
  if (options.engine != "local" || options.only >= 0 || options.slurm.plan) {
    return BadInput({options.study, "is a search for the best design", "--workers, --resume, --out",
                     "its runs depend on each other: leave --engine, --only and --plan away"});
  }
  const std::string out = options.common.out.empty() ? study.name : options.common.out;
  if (options.resume && sweep::IsFinished(out, study)) return TellFinished(options, study, out);
  return FindBestDesign(study, options.workers, out, options.resume, options.common);
}

int RunSweep(const SweepOptions& options) {
  const auto loaded = sweep::LoadStudy(options.study);
  if (!loaded.ok()) return BadInput(loaded.error());
  const Study& study = loaded.value();
  if (study.optimisation) return RunSearch(options, loaded.value());
  if (options.only >= 0) return RunOnly(options, study);
  const std::string out = options.common.out.empty() ? study.name : options.common.out;
  const sweep::SlurmOptions slurm = options.slurm.Over(study.slurm);
  if (!options.slurm.task.empty()) return RunSlurmTask(study, out, options.slurm.task);
  if (options.slurm.plan) return PrintSlurmPlan(study, slurm, out);
  if (options.resume && sweep::IsFinished(out, study)) return TellFinished(options, study, out);
  if (!options.resume) {
    if (Status s = sweep::CheckOutputs(study); !s.ok()) return BadInput(s.error());
  }
  auto work = sweep::WorkDir::Open(out, study, options.resume, options.common.force);
  if (!work.ok()) return BadInput(work.error());
  const auto code = options.engine == "slurm"
                        ? MakeRunsOnSlurm(study, slurm, &work.value(), options.common.quiet)
                        : MakeRunsHere(study, options.workers, &work.value(), options.common.quiet);
  if (code) return *code;
  return Conclude(options, study, &work.value());
}

}  // namespace

void AddSweep(CLI::App* verb, Action* action) {
  auto options = std::make_shared<SweepOptions>();
  AddCommonOptions(verb, &options->common);
  verb->add_option("study", options->study, "Scenario, axes and design (YAML)")->required();
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
