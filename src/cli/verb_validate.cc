// phs validate: every published check as a table: ours, reference, difference, tolerance.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/origin.h"
#include "base/result_dir.h"
#include "cli/verb_table.h"
#include "validate/check_groups.h"
#include "validate/known_misses.h"

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
    case validate::Claim::kOrientation:
      return "orientation";
  }
  return "";
}

/// In validate.json and, where it is no plain row that holds, in the table.
const char* VerdictWord(validate::Verdict verdict) {
  switch (verdict) {
    case validate::Verdict::kHolds:
      return "holds";
    case validate::Verdict::kMissed:
      return "MISSED";
    case validate::Verdict::kKnownMiss:
      return "missed, listed";
    case validate::Verdict::kHoldsAgain:
      return "HOLDS AGAIN, still listed";
    case validate::Verdict::kOrientation:
      return "orientation";
    case validate::Verdict::kSkipped:
      return "skipped";
  }
  return "";
}

Json ChecksJson(const validate::Judgement& judgement) {
  using validate::Verdict;
  Json json = {
      {"status", judgement.Passed() ? "ok" : "failed"},
      {"passed", judgement.Count(Verdict::kHolds)},
      {"failed", judgement.Count(Verdict::kMissed) + judgement.Count(Verdict::kHoldsAgain)},
      {"missed_and_listed", judgement.Count(Verdict::kKnownMiss)},
      {"orientation", judgement.Count(Verdict::kOrientation)},
      {"skipped", judgement.Count(Verdict::kSkipped)}};
  Json& rows = json["checks"] = Json::array();
  for (const validate::JudgedCheck& judged : judgement.rows) {
    const validate::Check& check = judged.check;
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
    row["verdict"] = VerdictWord(judged.verdict);
    if (!judged.reason.empty()) row["reason"] = judged.reason;
    row["source"] = check.source;
    rows.push_back(std::move(row));
  }
  return json;
}

void PrintRow(const validate::JudgedCheck& judged) {
  const validate::Check& check = judged.check;
  if (!check.skipped.empty()) {
    fmt::print("  {:<66} skipped: {}\n", check.what, check.skipped);
    return;
  }
  const char* sign = check.claim == validate::Claim::kAtMost    ? "<"
                     : check.claim == validate::Claim::kAtLeast ? ">"
                                                                : " ";
  const bool plain = judged.verdict == validate::Verdict::kHolds;
  const bool compared = check.claim != validate::Claim::kOrientation;
  fmt::print("  {:<66}{:>11.5g} {}{:>11.5g}{:>+11.2g}{:>10}  {:<6}{}{}\n", check.what, check.ours,
             sign, check.reference, check.Difference(),
             compared ? fmt::format("{:.2g}", check.tolerance) : "-", check.unit, plain ? "" : "  ",
             plain ? "" : VerdictWord(judged.verdict));
  if (!judged.reason.empty()) fmt::print("      because: {}\n", judged.reason);
}

void PrintTable(const validate::Judgement& judgement) {
  const std::vector<validate::JudgedCheck>& rows = judgement.rows;
  std::string group;
  for (size_t i = 0; i < rows.size(); ++i) {
    const validate::Check& check = rows[i].check;
    if (check.group != group) {
      group = check.group;
      for (const auto& known : validate::kCheckGroups) {
        if (group == known.name) {
          fmt::print("{}{}: {}\n  {:<66}{:>11}  {:>11}{:>11}{:>10}  unit\n", i == 0 ? "" : "\n",
                     known.name, known.text, "", "ours", "reference", "difference", "tolerance");
        }
      }
    }
    PrintRow(rows[i]);
    // One line of source under the rows that share it.
    const bool last = i + 1 == rows.size();
    if (last || rows[i + 1].check.group != check.group ||
        rows[i + 1].check.source != check.source) {
      fmt::print("      source: {}\n", check.source);
    }
  }
  using validate::Verdict;
  fmt::print(
      "\n{} hold, {} missed and listed (models/reference/known_misses.yaml), {} orientation, "
      "{} skipped\n",
      judgement.Count(Verdict::kHolds), judgement.Count(Verdict::kKnownMiss),
      judgement.Count(Verdict::kOrientation), judgement.Count(Verdict::kSkipped));
}

/// One line on stderr for all that is not as it should be.
void PrintFailures(const validate::Judgement& judgement) {
  for (const validate::JudgedCheck& row : judgement.rows) {
    if (row.verdict == validate::Verdict::kMissed) {
      fmt::print(stderr, "phs: {}: {}: missed: {:.5g} instead of {:.5g} {}, tolerance {:.2g}\n",
                 row.check.group, row.check.what, row.check.ours, row.check.reference,
                 row.check.unit, row.check.tolerance);
    } else if (row.verdict == validate::Verdict::kHoldsAgain) {
      fmt::print(stderr, "phs: {}: {}: holds again: take it out of known_misses.yaml\n",
                 row.check.group, row.check.what);
    }
  }
  for (const validate::KnownMiss& miss : judgement.unknown_rows) {
    fmt::print(stderr, "phs: {}: {}: listed in known_misses.yaml, but there is no such check\n",
               miss.group, miss.what);
  }
}

int RunValidate(const ValidateOptions& options) {
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const auto checks = validate::MakeChecks(options.groups);
  if (!checks.ok()) return BadInput(checks.error());
  const auto list = validate::ReferenceFile("known_misses.yaml");
  if (!list.ok()) return BadInput(list.error());
  const auto known = validate::LoadKnownMisses(list.value());
  if (!known.ok()) return BadInput(known.error());
  const validate::Judgement judgement = validate::Judge(checks.value(), known.value());
  const Json json = ChecksJson(judgement);
  if (options.common.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    PrintTable(judgement);
  }
  if (dir) {
    if (Status s = WriteFileAtomically(dir->File("validate.json"), json.dump(2) + "\n"); !s.ok()) {
      return BadInput(s.error());
    }
    if (Status s = WriteOrigin(dir->File("")); !s.ok()) return BadInput(s.error());
    if (Status s = dir->Commit(); !s.ok()) return BadInput(s.error());
  }
  PrintFailures(judgement);
  return judgement.Passed() ? kDone : kFailed;
}

}  // namespace

void AddValidate(CLI::App* verb, Action* action) {
  auto options = std::make_shared<ValidateOptions>();
  AddCommonOptions(verb, &options->common);
  verb->add_option("--group", options->groups, "Only these groups (all without it)");
  verb->footer(
      "Rows known to be missed stand in models/reference/known_misses.yaml with the reason.\n"
      "Exit code 1 for any other miss, and for a listed row that holds again. --out DIR writes\n"
      "validate.json.");
  verb->callback([=] { *action = [=] { return RunValidate(*options); }; });
}

}  // namespace phs::cli
