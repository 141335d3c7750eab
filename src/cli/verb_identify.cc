// phs identify: measured data and a declared model in, found effects and a corrected model out.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/result_dir.h"
#include "cli/verb_table.h"
#include "identify/identify_run.h"
#include "identify/steps_run.h"
#include "measurement/manifest.h"
#include "report/identify_report.h"

namespace phs::cli {
namespace {

struct IdentifyOptions {
  std::string manifest;
  CommonOptions common;
  identify::search::SearchOptions search;
};

/// The page is made from the saved files; one that cannot be drawn does not spoil the result.
Status WriteReport(const ResultDir& dir) {
  const Status s = report::WriteIdentifyReport({.result = dir.File("result.json"),
                                                .measured = dir.File("measured.csv"),
                                                .predicted = dir.File("predicted.csv"),
                                                .baseline = dir.File("baseline.csv")},
                                               dir.File("report.html"));
  if (s.ok() || IsDiskFault(s.error())) return s;
  std::fprintf(stderr, "phs: report: %s\n", s.error().Line().c_str());
  return {};
}

/// A table of steps has no clock: its own search (docs/rig_table_b1.md).
Result<identify::search::IdentifyOutcome> Identify(const IdentifyOptions& options,
                                                   const identify::search::Progress& progress,
                                                   const ResultDir& dir) {
  Result<measurement::Manifest> manifest = measurement::LoadManifest(options.manifest);
  if (!manifest.ok()) return manifest.error();
  if (manifest.value().rig != "steps") {
    return identify::search::RunIdentify(options.manifest, options.search, progress, dir);
  }
  Result<identify::RigOutcome> steps = identify::IdentifySteps(manifest.value(), dir);
  if (!steps.ok()) return steps.error();
  return identify::search::IdentifyOutcome{.result = steps.value().result,
                                           .summary = steps.value().summary};
}

int RunIdentifyVerb(const IdentifyOptions& options) {
  const std::string out = options.common.out.empty() ? "identify" : options.common.out;
  Result<ResultDir> dir = ResultDir::Create(out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  Result<identify::search::IdentifyOutcome> outcome = [&] {
    ProgressLine progress("identify", options.common.quiet);
    return Identify(
        options, [&](double share) { return progress(share); }, dir.value());
  }();
  if (!outcome.ok()) return BadInput(outcome.error());
  if (outcome.value().cancelled) {
    return Stopped("nothing written");
  }
  if (Status s = WriteReport(dir.value()); !s.ok()) return BadInput(s.error());
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  if (options.common.format == "json") {
    fmt::print("{}\n", outcome.value().result.dump(1));
  } else {
    fmt::print("{}{}/report.html\n", outcome.value().summary, out);
  }
  return kDone;
}

}  // namespace

void AddIdentify(CLI::App* verb, Action* action) {
  auto options = std::make_shared<IdentifyOptions>();
  verb->add_option("manifest", options->manifest, "Rig, model, data and windows (YAML)")
      ->required();
  verb->add_option("--threads", options->search.threads, "Candidates fitted at the same time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  verb->add_option("--max-effects", options->search.max_effects, "Effects added at most")
      ->check(CLI::Range(0, 6))
      ->capture_default_str();
  AddCommonOptions(verb, &options->common);
  verb->callback([=] { *action = [=] { return RunIdentifyVerb(*options); }; });
}

}  // namespace phs::cli
