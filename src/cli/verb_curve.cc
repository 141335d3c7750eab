// phs simulate, phs compare: runs on a track.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result_dir.h"
#include "base/words.h"
#include "cli/assessment_table.h"
#include "cli/curve_options.h"
#include "cli/curve_table.h"
#include "cli/number_within.h"
#include "cli/run_options.h"
#include "cli/run_remarks.h"
#include "cli/verb_table.h"
#include "jobs/curve_job.h"
#include "vehicle/scenario_file.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;
using vehicle::Scenario;

/// What a scenario says of a PHS that none of the bogies has.
std::string UnusedPhs(const jobs::Curve& curve) {
  const Scenario& s = curve.scenario;
  const bool has = std::any_of(curve.runs.begin(), curve.runs.end(), [](const auto& run) {
    return !run.simulation->binding().phs().empty();
  });
  std::vector<std::string> keys;
  if (!s.phs.empty()) keys.emplace_back("phs");
  if (!s.phs_changes.parameters.empty()) keys.emplace_back("phs_parameters");
  if (!s.phs_changes.effects.empty()) keys.emplace_back("effects");
  if (!s.phs_changes.failures.empty()) keys.emplace_back("failures");
  if (has || keys.empty()) return {};
  return fmt::format("! no bogie of this run has a PHS: without effect here: {}\n",
                     JoinWords(keys));
}

void PrintText(const CurveOptions& options, bool compare, const jobs::Curve& curve) {
  const vehicle::Simulation& first = *curve.runs[0].simulation;
  const NamedSummaries summaries = curve.Summaries();
  fmt::print("{}: track {}, {:.1f} km/h, friction {:.2f}, step {:g} ms\n\n", curve.scenario.name,
             first.binding().track().name(), curve.scenario.speed_m_s * 3.6,
             first.binding().friction(), curve.scenario.timestep_s * 1e3);
  fmt::print("{}{}\n{}\n{}", CurveTable(summaries), WarningLines(summaries) + UnusedPhs(curve),
             AssessmentTable(summaries), SteeringBudget(summaries));
  if (!options.verify) return;
  const Json ratios = compare ? curve.Compared()["discretisation"] : Json();
  fmt::print("\n{}", DiscretisationTable(summaries, ratios));
}

Result<bool> RunWatched(const CurveOptions& options, jobs::Curve* curve) {
  ProgressLine progress(curve->scenario.name, options.common.quiet);
  return jobs::RunCurve(curve, {.progress = [&](double share) { return progress(share); },
                                .stopped = [] { return StopSignal() != 0; }});
}

int RunCurve(CurveOptions options, bool compare) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  auto loaded = LoadCurve(options);
  if (!loaded.ok()) return BadInput(loaded.error());
  ListenForStop();
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  auto prepared = jobs::PrepareCurve(
      {.scenario = loaded.value(), .bogies = options.bogies, .verify = options.verify});
  if (!prepared.ok()) return BadInput(prepared.error());
  jobs::Curve& curve = prepared.value();
  const auto all = RunWatched(options, &curve);
  if (!all.ok()) return BadInput(all.error());
  if (!all.value()) return Stopped("nothing written");
  const Json compared = curve.Compared();
  if (options.common.format == "json") {
    fmt::print("{}\n", (compare ? compared : curve.runs[0].ToJson()).dump(2));
  } else {
    PrintText(options, compare, curve);
  }
  if (dir) {
    const auto files = compare ? jobs::CurveFiles::kCompare : jobs::CurveFiles::kSingle;
    if (Status s = jobs::WriteCurve(curve, files, options.csv, &*dir); !s.ok()) {
      return BadInput(s.error());
    }
    if (Status s = dir->Commit(); !s.ok()) return BadInput(s.error());
    if (options.common.format == "text") {
      fmt::print("\nReport: {}/report.html\n", dir->final_path());
    }
  }
  return options.checks.Conclude(curve.scenario.name, curve.Summaries(), kDone, compared["ratios"]);
}

void AddCurveOptions(CLI::App* verb, CurveOptions* options) {
  AddCommonOptions(verb, &options->common);
  verb->add_option("scenario", options->scenario, "Scenario: a name or a YAML file")->required();
  options->checks.AddOptions(verb);
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
      ->check(NumberWithin(1, 1e7));
  verb->add_flag("--stability", options->stability,
                 "With --radii: linear and non-linear critical speed of every bogie too");
  verb->callback([=] {
    *action = [=] {
      options->bogies = jobs::ExpandBogies(options->bogies);
      if (options->stability && options->radii_m.empty()) {
        return BadInput({"--stability", "is for several curves", "together with --radii",
                         "for one bogie use phs stability --ramp"});
      }
      return options->radii_m.empty() ? RunCurve(*options, true) : RunOverRadii(*options);
    };
  });
}

}  // namespace phs::cli
