// phs rig: a declared model driven by measured or generated motion, compared with what was
// measured.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/result_dir.h"
#include "cli/result_checks.h"
#include "cli/verb_table.h"
#include "jobs/rig_job.h"
#include "validate/source_tables.h"

namespace phs::cli {
namespace {

struct RigVerbOptions {
  std::string manifest;
  std::string table;
  CommonOptions common;
  ResultChecks checks;
};

int MissingManifest() {
  fmt::print(stderr, "manifest: is missing; a manifest of `phs list rigs`, a file, or --table\n");
  return kUsage;
}

/// A table of the source; its numbers as table.json where a directory is asked for.
int PrintSourceTable(const RigVerbOptions& options) {
  auto dir = OpenAskedDir(options.common);
  if (!dir.ok()) return BadInput(dir.error());
  const auto made = validate::MakeSourceTable(options.table);
  if (!made.ok()) return BadInput(made.error());
  const std::string json = made.value().json.dump(1) + "\n";
  if (dir.value()) {
    const std::string file = dir.value()->File("table.json");
    if (Status s = WriteFileAtomically(file, json); !s.ok()) return BadInput(s.error());
    if (Status s = dir.value()->Commit(); !s.ok()) return BadInput(s.error());
  }
  if (options.common.format == "json") {
    fmt::print("{}", json);
  } else {
    fmt::print("{}", made.value().text);
  }
  return options.checks.Conclude("rig", {{"table " + options.table, made.value().json}}, kDone);
}

int RunRigVerb(RigVerbOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  if (!options.table.empty()) return PrintSourceTable(options);
  if (options.manifest.empty()) return MissingManifest();
  const std::string out = options.common.out.empty() ? "rig" : options.common.out;
  Result<ResultDir> dir = ResultDir::Create(out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  Result<identify::RigOutcome> outcome = jobs::RunRig(options.manifest, dir.value());
  if (!outcome.ok()) return BadInput(outcome.error());
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  if (options.common.format == "json") {
    fmt::print("{}\n", outcome.value().result.dump(1));
  } else {
    fmt::print("{}{}/report.html\n", outcome.value().summary, out);
  }
  return options.checks.Conclude("rig", {{options.manifest, outcome.value().result}}, kDone);
}

}  // namespace

void AddRig(CLI::App* verb, Action* action) {
  auto options = std::make_shared<RigVerbOptions>();
  auto* manifest = verb->add_option("manifest", options->manifest,
                                    "Rig, model, data or signal (YAML; docs/rig.md)");
  verb->add_option("--table", options->table,
                   "A table of the thesis, measured beside ours, instead of a manifest")
      ->check(CLI::IsMember(validate::SourceTableNames()))
      ->excludes(manifest);
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->callback([=] { *action = [=] { return RunRigVerb(*options); }; });
}

}  // namespace phs::cli
