#include "sweep/run_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/json_path.h"
#include "base/numbers.h"
#include "base/result_dir.h"
#include "sweep/case_files.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Messages without the place where the run happened: they must not depend on the worker.
std::string Without(std::string text, const std::string& place) {
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at)) {
    text.erase(at, place.size());
  }
  return text;
}

Result<RunRecord> Calculate(const Study& study, int run, const std::string& scratch) {
  const auto file = WriteCaseFiles(study, run, scratch);
  if (!file.ok()) return file.error();
  const StudyCase& own = study.CaseOf(run);
  const auto made = own.analysis->run(file.value());
  if (!made.ok()) return made.error();
  const Json& summary = made.value().numbers;
  RunRecord record{run, made.value().status, made.value().reason, {}};
  for (const std::string& path : study.outputs) {
    const bool asked = own.outputs.empty() ||
                       std::find(own.outputs.begin(), own.outputs.end(), path) != own.outputs.end();
    if (!asked) {
      record.outputs.push_back(kNoNumber);
      continue;
    }
    const auto value = NumberAt(summary, path);
    if (value.ok()) {
      record.outputs.push_back(value.value());
    } else if (record.status == "ok" && !MayLack(*own.analysis, path)) {
      return AtOutput("outputs: " + path, value.error(), own);
    } else {  // a run that ended early has no steady curve; one without hunting no frequency
      record.outputs.push_back(kNoNumber);
    }
  }
  return record;
}

}  // namespace

Result<RunRecord> RunCase(const Study& study, int run, const std::string& scratch) {
  std::error_code fault, ignored;
  fs::create_directories(scratch, fault);
  if (fault) return WriteFault(scratch, fault.value());
  const auto made = Calculate(study, run, scratch);
  const bool there = fs::is_directory(scratch, fault);
  fs::remove_all(scratch, ignored);
  if (made.ok()) return made.value();
  if (IsDiskFault(made.error())) return made.error();
  if (!there) return WriteFault(scratch, ENOENT);  // someone has cleared it away
  return RunRecord{run, "error", Without(made.error().Line(), scratch + "/"),
                   std::vector<double>(study.outputs.size(), kNoNumber)};
}

RunRecord KilledRun(const Study& study, int run, const std::string& reason) {
  return {run, "killed", reason, std::vector<double>(study.outputs.size(), kNoNumber)};
}

std::string RecordPath(const std::string& directory, int run) {
  return (fs::path(directory) / "runs" / fmt::format("{:06}.json", run)).string();
}

Status WriteRecord(const RunRecord& record, const std::string& directory) {
  Json json = {{"run", record.run}, {"status", record.status}, {"reason", record.reason}};
  Json& outputs = json["outputs"] = Json::array();
  for (double value : record.outputs) {
    outputs.push_back(NumberOrNull(value));
  }
  return WriteFileAtomically(RecordPath(directory, record.run), json.dump() + "\n");
}

std::optional<RunRecord> ReadRecord(const Study& study, const std::string& directory, int run) {
  const auto text = ReadFile(RecordPath(directory, run));
  if (!text.ok()) return std::nullopt;
  RunRecord record{run, {}, {}, {}};
  try {
    const Json json = Json::parse(text.value());
    if (json.at("run") != run) return std::nullopt;
    record.status = json.at("status");
    record.reason = json.at("reason");
    for (const Json& value : json.at("outputs")) {
      record.outputs.push_back(value.is_number() ? value.get<double>() : kNoNumber);
    }
  } catch (const Json::exception&) {  // of another form: it is made again
    return std::nullopt;
  }
  if (record.status.empty() || record.outputs.size() != study.outputs.size()) return std::nullopt;
  return record;
}

}  // namespace phs::sweep
