// phs rig: a declared model driven by measured or generated motion, compared with what was
// measured.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/result_dir.h"
#include "cli/verb_table.h"
#include "identify/rig_run.h"
#include "measurement/manifest.h"
#include "report/identify_report.h"
#include "report/rig_report.h"

namespace phs::cli {
namespace {

struct RigVerbOptions {
  std::string manifest;
  CommonOptions common;
};

/// A clocked measurement has the report of an identification without its findings.
Status WriteReport(const ResultDir& dir, const measurement::Manifest& manifest) {
  const std::string page = dir.File("report.html");
  if (manifest.rig == "steps" || manifest.signal) {
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

int RunRigVerb(const RigVerbOptions& options) {
  Result<measurement::Manifest> manifest =
      measurement::LoadManifest(options.manifest, measurement::WindowNeed::kNone);
  if (!manifest.ok()) return BadInput(manifest.error());
  const std::string out = options.common.out.empty() ? "rig" : options.common.out;
  Result<ResultDir> dir = ResultDir::Create(out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  Result<identify::RigOutcome> outcome = identify::RunRig(manifest.value(), dir.value());
  if (!outcome.ok()) return BadInput(outcome.error());
  if (Status s = WriteReport(dir.value(), manifest.value()); !s.ok()) return BadInput(s.error());
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  if (options.common.format == "json") {
    fmt::print("{}\n", outcome.value().result.dump(1));
  } else if (!options.common.quiet) {
    fmt::print("{}{}/report.html\n", outcome.value().summary, out);
  }
  return kDone;
}

}  // namespace

void AddRig(CLI::App* verb, Action* action) {
  auto options = std::make_shared<RigVerbOptions>();
  verb->add_option("manifest", options->manifest, "Rig, model, data or signal (YAML; docs/rig.md)")
      ->required();
  AddCommonOptions(verb, &options->common);
  verb->callback([=] { *action = [=] { return RunRigVerb(*options); }; });
}

}  // namespace phs::cli
