// phs rig: a declared model driven by measured or generated motion, compared with what was
// measured.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/result_dir.h"
#include "cli/result_checks.h"
#include "cli/verb_table.h"
#include "jobs/rig_job.h"

namespace phs::cli {
namespace {

struct RigVerbOptions {
  std::string manifest;
  CommonOptions common;
  ResultChecks checks;
};

int RunRigVerb(RigVerbOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  const std::string out = options.common.out.empty() ? "rig" : options.common.out;
  Result<ResultDir> dir = ResultDir::Create(out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  Result<identify::RigOutcome> outcome = jobs::RunRig(options.manifest, dir.value());
  if (!outcome.ok()) return BadInput(outcome.error());
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  if (options.common.format == "json") {
    fmt::print("{}\n", outcome.value().result.dump(1));
  } else if (!options.common.quiet) {
    fmt::print("{}{}/report.html\n", outcome.value().summary, out);
  }
  return options.checks.Conclude("rig", {{options.manifest, outcome.value().result}}, kDone);
}

}  // namespace

void AddRig(CLI::App* verb, Action* action) {
  auto options = std::make_shared<RigVerbOptions>();
  verb->add_option("manifest", options->manifest, "Rig, model, data or signal (YAML; docs/rig.md)")
      ->required();
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->callback([=] { *action = [=] { return RunRigVerb(*options); }; });
}

}  // namespace phs::cli
