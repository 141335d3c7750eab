#include "identify/run/bogie_run.h"

#include <fmt/format.h>

#include "identify/models/bogie_data.h"
#include "identify/models/bogie_forward.h"
#include "identify/run/driven_run.h"
#include "identify/run/joined_run.h"
#include "phs_model/phs_model.h"
#include "vehicle/running_effects.h"
#include "vehicle/scenario_file.h"

namespace phs::identify::search {

using measurement::DataFinding;
using measurement::FitData;
using measurement::Manifest;
namespace {

using hydraulics::PhsParams;

struct BogieCase {
  BogieModel model;
  FitData data;
};

/// Where a record begins with the run, before a piston has moved, and has all ways: forces and
/// pressures are those at the ways.
void TakeWays(const Manifest& manifest, BogieCase* c) {
  constexpr double kBeyond_m = 2;
  const double begin = c->data.motion.front().position.front();
  BogieModel& model = c->model;
  model.by_measured_ways = manifest.measured_ways && begin <= model.start_m + kBeyond_m;
  model.by_measured_ways = BogieForward(c->data, model).ByMeasuredWays();
  if (!model.by_measured_ways) return;
  if (manifest.free.empty()) FreeByWays(&model);
  c->data.findings.push_back({"pistons",
                              "are measured: forces and pressures are those of the PHS "
                              "at these ways (ways: predicted takes the vehicle's)"});
}

/// Data and declared model, checked against each other.
Result<BogieCase> LoadBogieCase(const Manifest& manifest, bool several = false) {
  auto model = LoadBogieModel(manifest.model, manifest.free, manifest.candidates);
  if (!model.ok()) return model.error();
  BogieCase c{std::move(model).value(), {}};
  auto data = ReadBogieData(manifest, &c.model, several);
  if (!data.ok()) return data.error();
  c.data = std::move(data).value();
  TakeWays(manifest, &c);
  return c;
}

/// The same, with the step of the runs of a fit.
Result<BogieCase> LoadBogieToFit(const Manifest& manifest, int threads, bool several) {
  auto loaded = LoadBogieCase(manifest, several);
  if (!loaded.ok() || manifest.runs.front().estimation.empty()) return loaded;
  BogieCase& c = loaded.value();
  c.model.threads = threads;
  auto step = BogieForward(c.data, c.model).FitStep(c.model.phs);
  if (!step.ok()) return step.error();
  c.model.fit_step_s = step.value();
  return loaded;
}

/// Slow model: fewer runs.
SearchOptions ForBogie(const SearchOptions& asked, double step_s) {
  SearchOptions options = asked;
  options.formula = false;  // no single cylinder whose force could follow one
  options.effort.elsewhere = false;
  options.effort.coarse_step_s = 2 * step_s;
  options.effort.stepped = std::min(asked.effort.stepped, 9);
  options.effort.coarse_fits = std::min(asked.effort.coarse_fits, 3);
  options.effort.full_fits = std::min(asked.effort.full_fits, 3);
  options.effort.starts = 2;
  return options;
}

/// The scenario and the PHS model as two files.
Status WriteBogieModel(const ResultDir& dir, const std::string& file, const BogieCase& c,
                       const PhsParams& corrected) {
  auto scenario = ScenarioWith(c.model, corrected);
  if (!scenario.ok()) return scenario.status();
  PhsParams phs = corrected;
  phs.of_runs.clear();
  std::erase_if(phs.effects,
                [](const auto& e) { return vehicle::FindRunningEffect(e.name) != nullptr; });
  phs.name += "_identified";
  phs.description = "Identified from " + c.data.source + "; declared " + c.model.phs.name;
  std::string beside = file;
  beside.replace(0, std::string("model").size(), "phs");
  const std::string head = "# Identified from " + c.data.source + ", declared " +
                           c.model.scenario.name + ". " + beside + ": its PHS alone.\n";
  for (const Status& s :
       {WriteFileAtomically(dir.File(file), head + vehicle::ToYaml(scenario.value())),
        WriteFileAtomically(dir.File(beside), phs_model::ToYaml(phs))}) {
    if (!s.ok()) return s;
  }
  return {};
}

/// Several runs, each with its own speed and, where it has one, its own scenario.
Result<IdentifyOutcome> IdentifyBogieRuns(const Manifest& manifest, const SearchOptions& options,
                                          const Progress& progress, const ResultDir& dir) {
  std::vector<BogieCase> cases;
  for (size_t r = 0; r < manifest.runs.size(); ++r) {
    auto loaded = LoadBogieToFit(measurement::OfRun(manifest, r), options.effort.threads, true);
    if (!loaded.ok()) return loaded.error();
    cases.push_back(std::move(loaded).value());
  }
  std::vector<RunToJoin> runs;
  for (const BogieCase& c : cases) {
    runs.push_back({c.data, {std::make_shared<const BogieForward>(c.data, c.model), c.model.phs}});
  }
  const auto write = [&](size_t r, const std::string& file, const PhsParams& corrected) {
    return WriteBogieModel(dir, file, cases[r], corrected);
  };
  return SearchJoined(manifest, runs, ForBogie(options, cases.front().data.step_s), progress, write,
                      dir);
}

}  // namespace

Result<IdentifyOutcome> IdentifyBogie(const Manifest& manifest, const SearchOptions& options,
                                      const Progress& progress, const ResultDir& dir) {
  if (manifest.runs.size() > 1) return IdentifyBogieRuns(manifest, options, progress, dir);
  auto loaded = LoadBogieToFit(manifest, options.effort.threads, false);
  if (!loaded.ok()) return loaded.error();
  const BogieCase& c = loaded.value();
  const auto forward = std::make_shared<const BogieForward>(c.data, c.model);
  auto problem = FitProblem::Create(forward, c.model.phs, options.rule);
  if (!problem.ok()) return problem.error();
  const auto write = [&](const PhsParams& corrected) {
    return WriteBogieModel(dir, "model.yaml", c, corrected);
  };
  return SearchAndWrite(manifest, c.data, c.model.phs, &problem.value(),
                        ForBogie(options, c.data.step_s), progress, write, dir);
}

Result<IdentifyOutcome> RunBogieRig(const Manifest& manifest, const ResultDir& dir) {
  auto loaded = LoadBogieCase(manifest);
  if (!loaded.ok()) return loaded.error();
  const BogieCase& c = loaded.value();
  Channels predicted;
  const BogieForward forward(c.data, c.model);
  if (Status s = forward.Run(c.model.phs, ForwardModel::Span::kWhole, &predicted); !s.ok()) {
    return s.error();
  }
  IdentifyOutcome outcome;
  Json& result = outcome.result;
  result = Head(manifest, c.data);
  if (manifest.runs.front().estimation.empty()) {
    result.erase("estimation");
  } else {
    result["channels_estimation"] = ScoreChannels(c.data, predicted, c.data.estimation);
  }
  result["channels"] = ScoreChannels(c.data, predicted, c.data.validation);
  for (const DataFinding& f : c.data.findings) {
    outcome.summary += "data: " + f.channel + " " + f.text + "\n";
  }
  outcome.summary += fmt::format("{:28} {:>10} {:>8} {:>10} {:>10}\n", "channel", "RMSE", "NRMSE",
                                 "bias", "largest");
  for (const auto& [name, s] : result["channels"].items()) {
    outcome.summary +=
        fmt::format("{:28} {:>10.4g} {:>8.4f} {:>10.3g} {:>10.4g}\n", name, s["rmse"].get<double>(),
                    s["nrmse"].get<double>(), s["bias"].get<double>(), s["max"].get<double>());
  }
  for (const Status& s :
       {WriteMeasured(dir, c.data), WriteChannels(dir, "predicted.csv", c.data, predicted),
        WriteFileAtomically(dir.File("result.json"), result.dump(1) + "\n")}) {
    if (!s.ok()) return s.error();
  }
  return outcome;
}

}  // namespace phs::identify::search
