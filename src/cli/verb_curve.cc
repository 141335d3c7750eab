// phs simulate, phs compare: runs on a track.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>

#include "analysis/limits.h"
#include "analysis/running_assessment.h"
#include "base/result_dir.h"
#include "cli/assessment_table.h"
#include "cli/curve_options.h"
#include "cli/curve_table.h"
#include "cli/run_options.h"
#include "cli/run_remarks.h"
#include "cli/verb_table.h"
#include "report/curving_report.h"
#include "vehicle/compose.h"
#include "vehicle/discretisation.h"
#include "vehicle/result_files.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;
using vehicle::RunOutcome;
using vehicle::Scenario;
using vehicle::Simulation;

/// Beside the first run, or after it where the system gives no thread.
constexpr auto kAsideOrLater = std::launch::async | std::launch::deferred;

struct CurveRun {
  std::string bogie;
  std::optional<Simulation> simulation;
  RunOutcome outcome;
  Json summary;
};

/// Names of all runs; one that comes again gets a number ("phs@model_2").
std::vector<std::string> NamesOf(const std::vector<std::string>& asked) {
  std::vector<std::string> names;
  for (const std::string& bogie : asked) {
    const std::string name = vehicle::BogieLabel(bogie);
    std::string own = name;
    for (int k = 2; std::find(names.begin(), names.end(), own) != names.end(); ++k) {
      own = name + "_" + std::to_string(k);
    }
    names.push_back(own);
  }
  return names;
}

/// Creates all simulations first, so that bad input ends before any long work. With --verify the
/// runs at half step follow, in the same order.
Status CreateRuns(const CurveOptions& options, const Scenario& scenario,
                  std::vector<CurveRun>* runs) {
  const std::vector<std::string> names = NamesOf(options.bogies);
  for (size_t k = 0; k < (options.verify ? 2 : 1) * names.size(); ++k) {
    const size_t i = k % names.size();
    Scenario own = scenario;
    vehicle::UseBogie(options.bogies[i], &own);
    if (k >= names.size()) own.timestep_s = (*runs)[i].simulation->scenario().timestep_s / 2;
    auto simulation = Simulation::Create(own);
    if (!simulation.ok()) return simulation.error();
    runs->push_back({names[i], std::move(simulation).value(), {}, {}});
  }
  return {};
}

/// Runs two at a time; results do not depend on it. False: the user has stopped it.
Result<bool> RunAll(const CurveOptions& options, const Scenario& scenario,
                    std::vector<CurveRun>* runs) {
  ProgressLine progress(scenario.name, options.common.quiet);
  for (size_t i = 0; i < runs->size(); i += 2) {
    std::future<Result<RunOutcome>> second;
    if (i + 1 < runs->size()) {
      second = std::async(kAsideOrLater, [&, i] {
        return (*runs)[i + 1].simulation->Run([](double) { return StopSignal() == 0; });
      });
    }
    const double done = static_cast<double>(i) / static_cast<double>(runs->size());
    const double part = 2.0 / static_cast<double>(runs->size());
    auto first = (*runs)[i].simulation->Run(
        [&](double share) { return progress(std::min(1.0, done + part * share)); });
    if (!first.ok()) return first.error();
    (*runs)[i].outcome = std::move(first).value();
    if (second.valid()) {
      auto outcome = second.get();
      if (!outcome.ok()) return outcome.error();
      (*runs)[i + 1].outcome = std::move(outcome).value();
    }
  }
  // A run that was cut is no result, although it has all its files.
  for (const CurveRun& run : *runs) {
    if (run.outcome.status == "stopped") return false;
  }
  for (CurveRun& run : *runs) {
    run.summary = vehicle::Summarise(*run.simulation, run.outcome);
    run.summary["assessment"] = analysis::AssessRun(*run.simulation, run.outcome);
  }
  return true;
}

/// Takes the runs at half step out again and keeps what they say of the others.
void TakeHalfSteps(std::vector<CurveRun>* runs) {
  const size_t count = runs->size() / 2;
  for (size_t i = 0; i < count; ++i) {
    CurveRun& run = (*runs)[i];
    run.summary["discretisation"] =
        vehicle::Discretisation(run.outcome, run.summary, (*runs)[count + i].summary);
  }
  runs->erase(runs->begin() + static_cast<std::ptrdiff_t>(count), runs->end());
}

NamedSummaries Summaries(const std::vector<CurveRun>& runs) {
  NamedSummaries named;
  for (const CurveRun& run : runs) named.emplace_back(run.bogie, run.summary);
  return named;
}

/// compare.json, with the changes of the ratios if the half step was run.
Json CompareRuns(const CurveOptions& options, const Scenario& scenario,
                 const std::vector<CurveRun>& runs) {
  const NamedSummaries summaries = Summaries(runs);
  Json compared = vehicle::Compare(summaries, scenario, runs[0].simulation->binding().track());
  if (options.verify) compared["discretisation"] = vehicle::RatioChanges(summaries);
  return compared;
}

Status WriteResults(const CurveOptions& options, const Scenario& scenario, bool compare,
                    const std::vector<CurveRun>& runs, ResultDir* dir) {
  const Json compared = CompareRuns(options, scenario, runs);
  for (const CurveRun& run : runs) {
    const std::string stem = compare ? run.bogie + "_timeseries" : "timeseries";
    if (Status s = vehicle::WriteTimeSeries(run.outcome, dir->File(stem), options.csv); !s.ok()) {
      return s;
    }
  }
  Json main = compared;
  if (!compare) {
    main = runs[0].summary;
    main["scenario"] = compared["scenario"];
    main["track"] = compared["track"];
  }
  const std::string name = compare ? "compare.json" : "summary.json";
  if (Status s = WriteFileAtomically(dir->File(name), main.dump(2) + "\n"); !s.ok()) return s;
  return report::WriteCurvingReport(dir->File(""), dir->File("report.html"));
}

/// The file of limits, read before any long work; none without --check.
Result<std::vector<analysis::Limit>> ReadLimits(const CurveOptions& options) {
  if (options.limits.empty()) return std::vector<analysis::Limit>();
  return analysis::LoadLimits(options.limits);
}

/// Says on stderr what failed: runs and limits.
int ReportChecks(const CurveOptions& options, const std::string& name,
                 const std::vector<analysis::Limit>& limits, const NamedSummaries& summaries,
                 const Json& ratios) {
  auto checks = analysis::CheckLimits(limits, summaries, ratios);
  if (!checks.ok()) return BadInput(checks.error());
  if (!options.junit.empty()) {
    const std::string xml = analysis::JUnitXml(name, checks.value());
    if (Status s = WriteFileAtomically(options.junit, xml); !s.ok()) return BadInput(s.error());
  }
  int code = kDone;
  for (const analysis::LimitCheck& check : checks.value()) {
    if (check.Passed()) continue;
    fmt::print(stderr, "phs: {}\n", check.Text());
    code = kFailed;
  }
  return code;
}

int RunCurve(const CurveOptions& options, bool compare) {
  auto limits = ReadLimits(options);
  if (!limits.ok()) return BadInput(limits.error());
  auto loaded = LoadCurve(options);
  if (!loaded.ok()) return BadInput(loaded.error());
  Scenario scenario = std::move(loaded).value();
  CurveOptions chosen = options;
  if (chosen.bogies.empty()) chosen.bogies = {scenario.bogie};
  ListenForStop();
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  std::vector<CurveRun> runs;
  if (Status s = CreateRuns(chosen, scenario, &runs); !s.ok()) return BadInput(s.error());
  if (!(scenario.timestep_s > 0)) scenario.timestep_s = runs[0].simulation->scenario().timestep_s;
  const auto all = RunAll(chosen, scenario, &runs);
  if (!all.ok()) return BadInput(all.error());
  if (!all.value()) return Stopped("nothing written");
  if (chosen.verify) TakeHalfSteps(&runs);
  const NamedSummaries summaries = Summaries(runs);
  const Json compared = CompareRuns(chosen, scenario, runs);
  if (options.common.format == "json") {
    fmt::print("{}\n", (compare ? compared : runs[0].summary).dump(2));
  } else {
    const rail::Track& track = runs[0].simulation->binding().track();
    fmt::print("{}: track {}, {:.1f} km/h, friction {:.2f}, step {:g} ms\n\n", scenario.name,
               track.name(), scenario.speed_m_s * 3.6, runs[0].simulation->binding().friction(),
               scenario.timestep_s * 1e3);
    fmt::print("{}{}\n{}\n{}", CurveTable(summaries), WarningLines(summaries),
               AssessmentTable(summaries), SteeringBudget(summaries));
    if (chosen.verify) {
      const Json ratios = compare ? compared["discretisation"] : Json();
      fmt::print("\n{}", DiscretisationTable(summaries, ratios));
    }
  }
  if (dir) {
    if (Status s = WriteResults(chosen, scenario, compare, runs, &*dir); !s.ok()) {
      return BadInput(s.error());
    }
    if (Status s = dir->Commit(); !s.ok()) return BadInput(s.error());
    if (options.common.format == "text") {
      fmt::print("\nReport: {}/report.html\n", dir->final_path());
    }
  }
  return ReportChecks(options, scenario.name, limits.value(), summaries, compared["ratios"]);
}

/// "all" stands for every bogie that names a yardstick.
std::vector<std::string> ExpandBogies(const std::vector<std::string>& asked) {
  std::vector<std::string> bogies;
  for (const std::string& name : asked) {
    if (name != "all") {
      bogies.push_back(name);
      continue;
    }
    for (const vehicle::ComparedBogie& known : vehicle::ListComparedBogies()) {
      bogies.push_back(known.name);
    }
  }
  return bogies;
}

void AddCurveOptions(CLI::App* verb, CurveOptions* options) {
  AddCommonOptions(verb, &options->common);
  verb->add_option("scenario", options->scenario, "Scenario: a name or a YAML file")->required();
  verb->add_option("--check", options->limits,
                   "Limits (YAML) that the result must keep: else exit 1");
  verb->add_option("--junit", options->junit, "Write how runs and limits did as JUnit XML")
      ->check(NotEmpty);
  verb->add_option("--phs", options->phs,
                   "PHS model, instead of the bogie's: a name or a YAML file (the model.yaml of an "
                   "identification too)");
  verb->add_flag("--csv", options->csv, "Time series as CSV too");
  verb->add_flag("--verify", options->verify,
                 "Run the half step beside and say what moves by how much");
  AddTrackOption(verb, &options->track, "Track, instead of the scenario's: a name or a YAML file");
  AddTimestepOption(verb, &options->timestep_s);
  AddFrictionOption(verb, &options->friction);
}

}  // namespace

Result<Scenario> LoadCurve(const CurveOptions& options) {
  auto loaded = vehicle::LoadScenario(options.scenario);
  if (!loaded.ok()) return loaded.error();
  Scenario scenario = std::move(loaded).value();
  if (options.timestep_s > 0) scenario.timestep_s = options.timestep_s;
  if (!options.phs.empty()) scenario.phs = options.phs;
  if (!options.track.empty()) scenario.track = options.track;
  const rail::FrictionSettings& friction = options.friction;
  if (friction.tread >= 0 || !friction.condition.empty()) scenario.friction = friction;
  return scenario;
}

void AddSimulate(CLI::App* verb, Action* action) {
  auto options = std::make_shared<CurveOptions>();
  AddCurveOptions(verb, options.get());
  verb->add_option("--bogie", options->bogies, "Bogie, instead of the scenario's")->expected(1);
  verb->callback([=] { *action = [=] { return RunCurve(*options, false); }; });
}

void AddCompare(CLI::App* verb, Action* action) {
  auto options = std::make_shared<CurveOptions>();
  AddCurveOptions(verb, options.get());
  verb->add_option("--bogies", options->bogies,
                   "Bogies, separated by commas; all = every one with a yardstick; "
                   "BOGIE@FILE = with the PHS model of FILE")
      ->delimiter(',')
      ->required();
  verb->add_option(
          "--radii", options->radii_m,
          "Radii in metres, separated by commas: track and speed of scenario curve_rRADIUS "
          "each; prints a table, writes bogies.json and report.html")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  verb->add_flag("--stability", options->stability,
                 "With --radii: linear and non-linear critical speed of every bogie too");
  verb->callback([=] {
    *action = [=] {
      options->bogies = ExpandBogies(options->bogies);
      if (options->stability && options->radii_m.empty()) {
        return BadInput({"--stability", "is for several curves", "together with --radii",
                         "for one bogie use phs stability --ramp"});
      }
      return options->radii_m.empty() ? RunCurve(*options, true) : RunOverRadii(*options);
    };
  });
}

}  // namespace phs::cli
