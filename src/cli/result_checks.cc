#include "cli/result_checks.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <system_error>

#include "base/result_dir.h"
#include "cli/verbs.h"

namespace phs::cli {

void ResultChecks::AddOptions(CLI::App* verb) {
  verb->add_option("--check", limits_file_, "Limits (YAML) that the result must keep: else exit 1")
      ->check(NotEmpty);
  verb->add_option("--junit", junit_, "Write how runs and limits did as JUnit XML")
      ->check(NotEmpty);
}

Status ResultChecks::Read() {
  if (limits_file_.empty()) return {};
  auto read = analysis::LoadLimits(limits_file_);
  if (!read.ok()) return read.error();
  limits_ = std::move(read).value();
  return {};
}

int ResultChecks::Conclude(const std::string& suite, std::vector<analysis::NamedSummary> results,
                           int code, const nlohmann::ordered_json& ratios) const {
  for (analysis::NamedSummary& named : results) {
    if (!named.second.contains("status")) named.second["status"] = "ok";
  }
  const auto checks = analysis::CheckLimits(limits_, results, ratios);
  if (!checks.ok()) return BadInput(checks.error());
  if (!junit_.empty()) {
    const std::string xml = analysis::JUnitXml(suite, checks.value());
    std::error_code ignored;  // what cannot be made is said by the writing
    std::filesystem::create_directories(std::filesystem::absolute(junit_).parent_path(), ignored);
    for (const Status& s : {WriteFileAtomically(junit_, xml), AdoptIntoResult(junit_)}) {
      if (!s.ok()) return BadInput(s.error());
    }
  }
  for (const analysis::LimitCheck& check : checks.value()) {
    if (check.Passed()) continue;
    fmt::print(stderr, "phs: {}\n", check.Text());
    code = kFailed;
  }
  return code;
}

}  // namespace phs::cli
