#include "jobs/rig_job.h"

#include "base/origin.h"
#include "identify/run/identify_run.h"
#include "identify/run/rig_run.h"
#include "identify/run/steps_run.h"
#include "measurement/manifest.h"
#include "report/identify_report.h"
#include "report/rig_report.h"

namespace phs::jobs {
namespace {

using identify::search::IdentifyOutcome;

/// A clocked measurement has the report of an identification without its findings.
Status WriteRigPage(const ResultDir& dir, const measurement::Manifest& manifest,
                    const identify::RigOutcome& outcome) {
  const std::string page = dir.File("report.html");
  if (Status s = WriteOrigin(dir.File("")); !s.ok()) return s;
  if (manifest.rig == "steps" || outcome.measured.empty()) {
    return report::WriteRigReport({.result = dir.File("result.json"),
                                   .predicted = dir.File("predicted.csv"),
                                   .measured = dir.File("measured.csv")},
                                  page);
  }
  return report::WriteIdentifyReport({.result = dir.File("result.json"),
                                      .measured = dir.File("measured.csv"),
                                      .predicted = dir.File("predicted.csv")},
                                     page);
}

Status WriteIdentifyPage(const ResultDir& dir) {
  if (Status s = WriteOrigin(dir.File("")); !s.ok()) return s;
  return report::WriteIdentifyReport({.result = dir.File("result.json"),
                                      .measured = dir.File("measured.csv"),
                                      .predicted = dir.File("predicted.csv"),
                                      .baseline = dir.File("baseline.csv")},
                                     dir.File("report.html"));
}

/// A table of steps has no clock: its own search (docs/rig_table_b1.md).
Result<IdentifyOutcome> Search(const std::string& path,
                               const identify::search::SearchOptions& options, const Watch& watch,
                               const ResultDir& dir) {
  Result<measurement::Manifest> manifest = measurement::LoadManifest(path);
  if (!manifest.ok()) return manifest.error();
  if (manifest.value().rig != "steps") {
    return identify::search::RunIdentify(
        path, options, [&](double share) { return watch.GoesOn(share); }, dir);
  }
  if (!options.between.empty()) {
    return Error{"--between", "no motion drives a table of steps",
                 "rigs cylinder, quarter, full, element", ""};
  }
  bool stopped = false;
  const auto go_on = [&] { return !(stopped = stopped || !watch.GoesOn(0)); };
  Result<identify::RigOutcome> steps = identify::IdentifySteps(manifest.value(), dir, go_on);
  if (stopped || !go_on()) return IdentifyOutcome{.cancelled = true};
  if (!steps.ok()) return steps.error();
  return IdentifyOutcome{.result = steps.value().result, .summary = steps.value().summary};
}

/// What is wrong with names that a manifest asks for is told with the manifest.
Error InManifest(const std::string& path, Error error) {
  for (const char* key : {"free: ", "candidates: "}) {
    if (error.where.starts_with(key)) error.where = path + ": " + error.where;
  }
  return error;
}

}  // namespace

Result<identify::RigOutcome> RunRig(const std::string& name, const ResultDir& dir) {
  const auto path = measurement::FindManifest(name);
  if (!path.ok()) return path.error();
  Result<measurement::Manifest> manifest =
      measurement::LoadManifest(path.value(), measurement::WindowNeed::kNone);
  if (!manifest.ok()) return manifest.error();
  Result<identify::RigOutcome> outcome = identify::RunRig(manifest.value(), dir);
  if (!outcome.ok()) return InManifest(path.value(), outcome.error());
  if (Status s = WriteRigPage(dir, manifest.value(), outcome.value()); !s.ok()) return s.error();
  return outcome;
}

Result<Identified> Identify(const std::string& manifest,
                            const identify::search::SearchOptions& options, const Watch& watch,
                            const ResultDir& dir) {
  const auto path = measurement::FindManifest(manifest);
  if (!path.ok()) return path.error();
  Result<IdentifyOutcome> outcome = Search(path.value(), options, watch, dir);
  if (!outcome.ok()) return InManifest(path.value(), outcome.error());
  Identified identified{std::move(outcome).value(), {}};
  if (identified.outcome.cancelled) return identified;
  const Status page = WriteIdentifyPage(dir);
  if (page.ok()) return identified;
  if (IsDiskFault(page.error())) return page.error();
  identified.report_fault = page.error();
  return identified;
}

}  // namespace phs::jobs
