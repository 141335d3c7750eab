// What the page of a sweep needs beside its table, as a file of the result.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/disk.h"
#include "report/json_fields.h"
#include "report/page_links.h"
#include "report/sweep_report.h"

namespace phs::report {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

json IndicesJson(const OutputIndices& of) {
  return {{"output", of.output},
          {"first", of.first},
          {"total", of.total},
          {"first_error", of.first_error},
          {"total_error", of.total_error}};
}

OutputIndices IndicesFrom(const json& saved) {
  OutputIndices of;
  saved.at("output").get_to(of.output);
  saved.at("first").get_to(of.first);
  saved.at("total").get_to(of.total);
  saved.at("first_error").get_to(of.first_error);
  saved.at("total_error").get_to(of.total_error);
  return of;
}

SweepReportInput InputFrom(const json& saved, const fs::path& folder) {
  SweepReportInput input;
  input.table = (folder / saved.at("table").get<std::string>()).string();
  saved.at("parameters").get_to(input.parameters);
  saved.at("outputs").get_to(input.outputs);
  saved.at("sampled").get_to(input.sampled);
  saved.at("study").get_to(input.study);
  for (const json& one : saved.at("indices")) input.indices.push_back(IndicesFrom(one));
  return input;
}

}  // namespace

Status KeepSweepReportInput(const SweepReportInput& input) {
  json saved = {{"table", fs::path(input.table).filename().string()},
                {"study", input.study},
                {"parameters", input.parameters},
                {"outputs", input.outputs},
                {"sampled", input.sampled},
                {"indices", json::array()}};
  for (const OutputIndices& of : input.indices) saved["indices"].push_back(IndicesJson(of));
  const fs::path file = fs::path(input.table).parent_path() / kSweepReportInput;
  return WriteFileAtomically(file.string(), saved.dump(2) + "\n");
}

Status RemakeSweepReport(const std::string& folder) {
  const fs::path file = fs::path(folder) / kSweepReportInput;
  if (!fs::exists(file)) {
    return Error{folder, std::string("has no ") + kSweepReportInput,
                 "a sweep with at least one run that ended well and a varied number; one made by "
                 "this version",
                 "phs sweep STUDY --out DIR makes it anew"};
  }
  const Result<json> read = ReadJsonObject(file.string());
  if (!read.ok()) return read.error();
  return MakeGuarded(file.string(), [&] {
    return WriteSweepReport(InputFrom(read.value(), folder),
                            (fs::path(folder) / kReportName).string());
  });
}

}  // namespace phs::report
