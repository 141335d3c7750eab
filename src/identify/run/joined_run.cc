#include "identify/run/joined_run.h"

#include <fmt/format.h>

namespace phs::identify::search {

using hydraulics::PhsParams;
using measurement::FitData;
using measurement::JoinedData;
using measurement::Manifest;

std::vector<std::string> SharedNumbers(const Manifest& manifest, const JoinedPart& first) {
  if (measurement::HasOwnModels(manifest)) return manifest.shared;
  std::vector<std::string> names;
  for (const FreeParameter& p : first.forward->Declared(first.declared).free) {
    names.push_back(p.name);
  }
  return names;
}

Result<IdentifyOutcome> SearchJoined(const Manifest& manifest, const std::vector<RunToJoin>& runs,
                                     const SearchOptions& options, const Progress& progress,
                                     const WriteRunModel& write, const ResultDir& dir) {
  std::vector<FitData> data;
  std::vector<JoinedPart> parts;
  for (const RunToJoin& run : runs) data.push_back(run.data), parts.push_back(run.part);
  Result<JoinedData> joined = measurement::JoinData(data);
  if (!joined.ok()) return joined.error();
  const auto whole = std::make_shared<const JoinedData>(std::move(joined.value()));
  auto forward = JoinedForward::Create(parts, SharedNumbers(manifest, parts.front()), whole);
  if (!forward.ok()) {
    Error error = forward.error();
    error.where = manifest.path + ": " + error.where;
    return error;
  }
  const JoinedForward& all = *forward.value();
  Result<FitProblem> problem = FitProblem::Create(forward.value(), all.declared(), options.rule);
  if (!problem.ok()) return problem.error();
  const size_t models = measurement::HasOwnModels(manifest) ? runs.size() : 1;
  const auto write_all = [&](const PhsParams& corrected) {
    for (size_t r = 0; r < models; ++r) {
      const std::string file = r == 0 ? "model.yaml" : fmt::format("model_{}.yaml", r + 1);
      if (Status s = write(r, file, all.ParamsOf(corrected, r)); !s.ok()) return s;
    }
    return Status();
  };
  return SearchAndWrite(manifest, whole->data, all.declared(), &problem.value(), options, progress,
                        write_all, dir);
}

}  // namespace phs::identify::search
