// phs identify: measured data and a declared model in, found effects and a corrected model out.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "base/result_dir.h"
#include "cli/result_checks.h"
#include "cli/verb_table.h"
#include "jobs/rig_job.h"

namespace phs::cli {
namespace {

struct IdentifyOptions {
  std::string manifest;
  CommonOptions common;
  ResultChecks checks;
  identify::search::SearchOptions search;
};

int RunIdentifyVerb(IdentifyOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  const std::string out = options.common.out.empty() ? "identify" : options.common.out;
  Result<ResultDir> dir = ResultDir::Create(out, options.common.force);
  if (!dir.ok()) return BadInput(dir.error());
  const Result<jobs::Identified> identified = [&] {
    ProgressLine progress("identify", options.common.quiet);
    return jobs::Identify(options.manifest, options.search,
                          {.progress = [&](double share) { return progress(share); }}, dir.value());
  }();
  if (!identified.ok()) return BadInput(identified.error());
  const auto& [outcome, report_fault] = identified.value();
  if (outcome.cancelled) return Stopped("nothing written");
  if (report_fault) std::fprintf(stderr, "phs: report: %s\n", report_fault->Line().c_str());
  if (Status s = dir.value().Commit(); !s.ok()) return BadInput(s.error());
  if (options.common.format == "json") {
    fmt::print("{}\n", outcome.result.dump(1));
  } else {
    fmt::print("{}{}/report.html\n", outcome.summary, out);
  }
  return options.checks.Conclude("identify", {{options.manifest, outcome.result}}, kDone);
}

}  // namespace

void AddIdentify(CLI::App* verb, Action* action) {
  auto options = std::make_shared<IdentifyOptions>();
  verb->add_option("manifest", options->manifest, "Rig, model, data and windows (YAML)")
      ->required();
  verb->add_option("--threads", options->search.effort.threads,
                   "Candidates fitted at the same time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  verb->add_option("--max-effects", options->search.effort.max_effects, "Effects added at most")
      ->check(CLI::Range(0, 6))
      ->capture_default_str();
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->callback([=] { *action = [=] { return RunIdentifyVerb(*options); }; });
}

}  // namespace phs::cli
