#include "jobs/curve_job.h"

#include <algorithm>
#include <future>

#include "analysis/running_assessment_json.h"
#include "base/origin.h"
#include "film/film.h"
#include "report/curving_report.h"
#include "vehicle/compose.h"
#include "vehicle/result_files.h"
#include "vehicle/summary.h"

namespace phs::jobs {
namespace {

using Json = nlohmann::ordered_json;
using vehicle::RunOutcome;
using vehicle::Scenario;
using vehicle::Simulation;

/// Beside the first run, or after it where the system gives no thread.
constexpr auto kAsideOrLater = std::launch::async | std::launch::deferred;

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

/// Takes the runs at half step out again and keeps what they say of the others.
void TakeHalfSteps(std::vector<CurveRun>* runs) {
  const size_t count = runs->size() / 2;
  for (size_t i = 0; i < count; ++i) {
    CurveRun& run = (*runs)[i];
    run.discretisation =
        vehicle::ChangesAtHalfStep(run.outcome, run.summary, (*runs)[count + i].summary);
  }
  runs->erase(runs->begin() + static_cast<std::ptrdiff_t>(count), runs->end());
}

Result<RunOutcome> RunOne(const Curve& curve, CurveRun* run, const vehicle::Progress& progress) {
  const vehicle::OwnInputs own = curve.own ? curve.own(*run->simulation) : vehicle::OwnInputs();
  return run->simulation->Run(progress, own);
}

}  // namespace

Json CurveRun::ToJson() const {
  nlohmann::ordered_json json = vehicle::SummaryJson(summary);
  json["assessment"] = analysis::AssessmentJson(assessment);
  if (discretisation) json["discretisation"] = vehicle::DiscretisationJson(*discretisation);
  json["conicity"] = analysis::ConicityJson(conicity);
  return json;
}

NamedSummaries Curve::Summaries() const {
  NamedSummaries named;
  for (const CurveRun& run : runs) named.emplace_back(run.bogie, run.ToJson());
  return named;
}

Json Curve::Compared() const {
  const NamedSummaries summaries = Summaries();
  Json compared = vehicle::Compare(summaries, scenario, runs[0].simulation->binding().track());
  if (!verify) return compared;
  std::vector<std::pair<std::string, vehicle::StepChanges>> changes;
  for (const CurveRun& run : runs) {
    if (run.discretisation) changes.emplace_back(run.bogie, *run.discretisation);
  }
  compared["discretisation"] = vehicle::DiscretisationJson(vehicle::RatioChanges(changes));
  return compared;
}

Json Curve::Single() const {
  Json single = runs[0].ToJson();
  single["scenario"] = vehicle::DescribeScenario(scenario);
  single["track"] = vehicle::DescribeTrack(runs[0].simulation->binding().track());
  return single;
}

/// With `verify` the runs at half step follow the others, in the same order.
Result<Curve> PrepareCurve(const CurveRequest& request) {
  Curve curve{request.scenario, request.verify, request.own, {}};
  const std::vector<std::string> bogies =
      request.bogies.empty() ? std::vector<std::string>{curve.scenario.bogie} : request.bogies;
  const std::vector<std::string> names = NamesOf(bogies);
  for (size_t k = 0; k < (curve.verify ? 2 : 1) * names.size(); ++k) {
    const size_t i = k % names.size();
    Scenario own = curve.scenario;
    vehicle::UseBogie(bogies[i], &own);
    if (k >= names.size()) own.timestep_s = curve.runs[i].simulation->scenario().timestep_s / 2;
    auto simulation = Simulation::Create(own);
    if (!simulation.ok()) return simulation.error();
    curve.runs.push_back({names[i], std::move(simulation).value()});
  }
  if (!(curve.scenario.timestep_s > 0)) {
    curve.scenario.timestep_s = curve.runs[0].simulation->scenario().timestep_s;
  }
  return curve;
}

Result<bool> RunCurve(Curve* curve, const Watch& watch) {
  std::vector<CurveRun>& runs = curve->runs;
  for (size_t i = 0; i < runs.size(); i += 2) {
    std::future<Result<RunOutcome>> second;
    if (i + 1 < runs.size()) {
      second = std::async(kAsideOrLater, [&, i] {
        return RunOne(*curve, &runs[i + 1], [&](double) { return !watch.IsStopped(); });
      });
    }
    const double done = static_cast<double>(i) / static_cast<double>(runs.size());
    const double part = 2.0 / static_cast<double>(runs.size());
    auto first = RunOne(*curve, &runs[i], [&](double share) {
      return watch.GoesOn(std::min(1.0, done + part * share));
    });
    if (!first.ok()) return first.error();
    runs[i].outcome = std::move(first).value();
    if (second.valid()) {
      auto outcome = second.get();
      if (!outcome.ok()) return outcome.error();
      runs[i + 1].outcome = std::move(outcome).value();
    }
  }
  // A run that was cut is no result, although it has all its files.
  for (const CurveRun& run : runs) {
    if (run.outcome.status == "stopped") return false;
  }
  for (CurveRun& run : runs) {
    run.summary = vehicle::Summarise(*run.simulation, run.outcome);
    run.assessment = analysis::AssessRun(*run.simulation, run.outcome);
  }
  if (curve->verify) TakeHalfSteps(&runs);
  for (CurveRun& run : runs) run.conicity = analysis::CalcConicity(*run.simulation);
  return true;
}

Status WriteCurve(const Curve& curve, CurveFiles files, bool csv, ResultDir* dir) {
  const bool compare = files == CurveFiles::kCompare;
  for (const CurveRun& run : curve.runs) {
    const std::string stem = compare ? run.bogie + "_timeseries" : "timeseries";
    if (Status s = vehicle::WriteTimeSeries(run.outcome, dir->File(stem), csv); !s.ok()) return s;
  }
  const Json main = compare ? curve.Compared() : curve.Single();
  const std::string name = compare ? "compare.json" : "summary.json";
  if (Status s = WriteFileAtomically(dir->File(name), main.dump(2) + "\n"); !s.ok()) return s;
  if (Status s = WriteOrigin(dir->File("")); !s.ok()) return s;
  const report::Replay replay = film::FilmOrReason(dir->File(""));
  return report::WriteCurvingReport(dir->File(""), dir->File("report.html"), &replay);
}

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

}  // namespace phs::jobs
