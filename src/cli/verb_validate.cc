// phs validate: every published check as a table: ours, reference, difference, tolerance.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/result_dir.h"
#include "cli/verbs.h"
#include "validate/check.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct ValidateOptions {
  CommonOptions common;
  std::vector<std::string> groups;
};

const char* ClaimWord(validate::Claim claim) {
  switch (claim) {
    case validate::Claim::kNear:
      return "near";
    case validate::Claim::kAtMost:
      return "at_most";
    case validate::Claim::kAtLeast:
      return "at_least";
  }
  return "";
}

Json ChecksJson(const validate::Checks& checks) {
  Json json = {{"status", "ok"}, {"passed", 0}, {"failed", 0}, {"skipped", 0}};
  Json& rows = json["checks"] = Json::array();
  for (const validate::Check& check : checks) {
    Json row = {{"group", check.group}, {"what", check.what}, {"unit", check.unit}};
    if (check.skipped.empty()) {
      row.update({{"ours", check.ours},
                  {"reference", check.reference},
                  {"difference", check.Difference()},
                  {"tolerance", check.tolerance},
                  {"claim", ClaimWord(check.claim)}});
    } else {
      row["skipped"] = check.skipped;
    }
    row["passed"] = check.Passed();
    row["source"] = check.source;
    rows.push_back(std::move(row));
    Json& count = json[!check.skipped.empty() ? "skipped" : check.Passed() ? "passed" : "failed"];
    count = count.get<int>() + 1;
  }
  if (json["failed"] != 0) json["status"] = "failed";
  return json;
}

void PrintRow(const validate::Check& check) {
  if (!check.skipped.empty()) {
    fmt::print("  {:<66} skipped: {}\n", check.what, check.skipped);
    return;
  }
  const char* sign = check.claim == validate::Claim::kAtMost    ? "<"
                     : check.claim == validate::Claim::kAtLeast ? ">"
                                                                : " ";
  fmt::print("  {:<66}{:>11.5g} {}{:>11.5g}{:>+11.2g}{:>10.2g}  {:<6}{}\n", check.what, check.ours,
             sign, check.reference, check.Difference(), check.tolerance, check.unit,
             check.Passed() ? "" : "  MISSED");
}

void PrintTable(const validate::Checks& checks, const Json& json) {
  std::string group;
  for (const validate::Check& check : checks) {
    if (check.group != group) {
      group = check.group;
      for (const auto& known : validate::AllCheckGroups()) {
        if (group == known.name) {
          fmt::print("{}{}: {}\n  {:<66}{:>11}  {:>11}{:>11}{:>10}  unit\n",
                     &check == &checks.front() ? "" : "\n", known.name, known.about, "", "ours",
                     "reference", "difference", "tolerance");
        }
      }
    }
    PrintRow(check);
    // One line of source under the rows that share it.
    const validate::Check* next = &check + 1;
    const bool last = next == checks.data() + checks.size();
    if (last || next->group != check.group || next->source != check.source) {
      fmt::print("      source: {}\n", check.source);
    }
  }
  fmt::print("\n{} checks hold, {} missed, {} skipped\n", json["passed"].get<int>(),
             json["failed"].get<int>(), json["skipped"].get<int>());
}

int RunValidate(const ValidateOptions& options) {
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const auto checks = validate::MakeChecks(options.groups);
  if (!checks.ok()) return BadInput(checks.error());
  const Json json = ChecksJson(checks.value());
  if (options.common.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    PrintTable(checks.value(), json);
  }
  if (dir) {
    if (Status s = WriteFileAtomically(dir->File("validate.json"), json.dump(2) + "\n"); !s.ok()) {
      return BadInput(s.error());
    }
    if (Status s = dir->Commit(); !s.ok()) return BadInput(s.error());
  }
  return json["failed"] == 0 ? kDone : kFailed;
}

}  // namespace

void AddValidate(CLI::App* app, Action* action) {
  CLI::App* verb = app->add_subcommand(
      "validate", "Every published check: ours, reference, difference, tolerance");
  auto options = std::make_shared<ValidateOptions>();
  AddCommonOptions(verb, &options->common);
  verb->add_option("--group", options->groups, "Only these groups (all without it)");
  verb->footer("Exit code 1 when a tolerance is missed. --out DIR writes validate.json.");
  verb->callback([=] { *action = [=] { return RunValidate(*options); }; });
}

}  // namespace phs::cli
