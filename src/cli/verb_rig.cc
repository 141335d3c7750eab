// phs rig: a declared model driven by measured motion, compared with what was measured.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

#include "base/result_dir.h"
#include "cli/verbs.h"
#include "identify/identify_run.h"
#include "identify/manifest.h"
#include "report/identify_report.h"

namespace phs::cli {
namespace {

struct RigVerbOptions {
  std::string manifest;
  CommonOptions common;
};

/// What was compared, where the run saved it; else the first run's data.
std::string MeasuredFile(const ResultDir& dir, const identify::Manifest& manifest) {
  const std::string saved = dir.File("measured.csv");
  return std::filesystem::exists(saved) ? saved : manifest.runs.front().data;
}

int RunRigVerb(const RigVerbOptions& options) {
  const std::string out = options.common.out.empty() ? "rig" : options.common.out;
  Result<ResultDir> dir = ResultDir::Create(out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  Result<identify::search::IdentifyOutcome> outcome =
      identify::search::RunRig(options.manifest, dir.value());
  if (!outcome.ok()) return BadInput(outcome.error());
  const auto manifest = identify::LoadManifest(options.manifest);
  if (manifest.ok()) {
    const Status s =
        report::WriteIdentifyReport({.result = dir.value().File("result.json"),
                                     .measured = MeasuredFile(dir.value(), manifest.value()),
                                     .predicted = dir.value().File("predicted.csv")},
                                    dir.value().File("report.html"));
    if (!s.ok()) std::fprintf(stderr, "phs: report: %s\n", s.error().Line().c_str());
  }
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  if (options.common.format == "json") {
    fmt::print("{}\n", outcome.value().result.dump(1));
  } else {
    fmt::print("{}{}/report.html\n", outcome.value().summary, out);
  }
  return kDone;
}

}  // namespace

void AddRig(CLI::App* app, Action* action) {
  CLI::App* verb = app->add_subcommand(
      "rig", "A hydraulic rig driven by measured motion, compared with measured forces");
  auto options = std::make_shared<RigVerbOptions>();
  verb->add_option("manifest", options->manifest, "Rig, model, data and windows (YAML)")
      ->required();
  AddCommonOptions(verb, &options->common);
  verb->callback([=] { *action = [=] { return RunRigVerb(*options); }; });
}

}  // namespace phs::cli
