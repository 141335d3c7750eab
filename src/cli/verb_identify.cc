// phs identify: measured data and a declared model in, found effects and a corrected model out.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>

#include "base/numbers.h"
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
  std::vector<std::string> numbers, without;  ///< of the rule of acceptance
};

/// The rule with what was asked of it.
Result<identify::SearchRule> AskedRule(const IdentifyOptions& options) {
  identify::SearchRule rule;
  for (const std::string& asked : options.numbers) {
    const size_t equals = asked.find('=');
    const auto all = identify::AcceptanceNumbers();
    const auto row = std::find_if(all.begin(), all.end(), [&](const auto& r) {
      return asked.compare(0, equals, r.name) == 0;
    });
    std::string names;
    for (const auto& r : all) names += (names.empty() ? "" : ", ") + std::string(r.name);
    if (equals == std::string::npos || row == all.end()) {
      return Error{"--rule " + asked, "is no number of the rule of acceptance",
                   "NAME=VALUE with " + names, "see docs/identify_rule.md"};
    }
    const auto value = ParseNumber(asked.substr(equals + 1));
    if (!value || !(*value >= row->low && *value <= row->high)) {
      return Error{"--rule " + asked, "is out of range",
                   fmt::format("{} = {:g} … {:g}", row->name, row->low, row->high), ""};
    }
    rule.accept.*row->value = *value;
  }
  for (const identify::RulePart& part : identify::RuleParts()) {
    const auto& left_out = options.without;
    rule.*part.holds = std::find(left_out.begin(), left_out.end(), part.name) == left_out.end();
  }
  return rule;
}

std::vector<std::string> PartNames() {
  std::vector<std::string> names;
  for (const identify::RulePart& part : identify::RuleParts()) names.push_back(part.name);
  return names;
}

std::string PartsInWords() {
  std::string text = "Parts of the rule, for --without:\n";
  for (const identify::RulePart& part : identify::RuleParts()) {
    text += fmt::format("  {:<18}{}\n", part.name, part.text);
  }
  return text;
}

int RunIdentifyVerb(IdentifyOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  const Result<identify::SearchRule> rule = AskedRule(options);
  if (!rule.ok()) return BadInput(rule.error());
  options.search.rule = rule.value();
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
  verb->add_option("--between", options->search.between,
                   "Two effects, ONE,OTHER, that the next test is to tell apart")
      ->delimiter(',')
      ->transform([](const std::string& name) { return CLI::detail::trim_copy(name); }, "")
      ->allow_extra_args(false);
  verb->add_option("--rule", options->numbers,
                   "Another number of the rule of acceptance, NAME=VALUE (false_alarms, …)")
      ->allow_extra_args(false);
  verb->add_option("--without", options->without,
                   "A part of the search's rule left out, to see what it is worth")
      ->allow_extra_args(false)
      ->check(CLI::IsMember(PartNames()));
  verb->footer(PartsInWords());
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->callback([=] { *action = [=] { return RunIdentifyVerb(*options); }; });
}

}  // namespace phs::cli
