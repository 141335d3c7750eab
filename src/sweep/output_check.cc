#include "sweep/output_check.h"

#include <optional>
#include <set>

#include "base/json_path.h"
#include "base/local_folder.h"
#include "sweep/analyses.h"
#include "sweep/case_files.h"

namespace phs::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMostVehicles = 20;

/// The numbers of one run by name; their values mean nothing. Nothing where it cannot be told.
std::optional<Json> NumbersOf(const Study& study, int run) {
  const LocalFolder scratch;
  const auto file = WriteCaseFiles(study, run, scratch.path());
  if (!file.ok()) return std::nullopt;
  const Analysis& analysis = *study.CaseOf(run).analysis;
  auto made = analysis.names != nullptr ? analysis.names(file.value(), study.outputs)
                                        : analysis.run(file.value());
  return made.ok() ? std::optional(std::move(made).value().numbers) : std::nullopt;
}

/// What tells one vehicle or rig of a study from another: the words among a run's values, and its case.
std::string VehicleOf(const Study& study, int run) {
  std::string words = std::to_string(
      study.case_of_run.empty() ? 0 : study.case_of_run[static_cast<std::size_t>(run)]);
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    for (const std::string& key : study.CaseOf(run).subject->kinds) {
      if (study.axes[i].key == key) words += "," + study.runs[static_cast<std::size_t>(run)][i];
    }
  }
  return words;
}

}  // namespace

Status CheckOutputs(const Study& study) {
  std::set<std::string> vehicles;
  std::vector<std::string> open = study.outputs;
  std::optional<Json> first;
  for (int run = 0; run < study.num_runs() && !open.empty(); ++run) {
    if (!vehicles.insert(VehicleOf(study, run)).second) continue;
    if (vehicles.size() > kMostVehicles) return {};
    const auto numbers = NumbersOf(study, run);
    if (!numbers) return {};  // the run itself says what is wrong with it
    std::erase_if(open, [&](const std::string& path) { return NumberAt(*numbers, path).ok(); });
    if (!first) first = numbers;
  }
  if (open.empty() || !first) return {};
  return AtOutput(study.path + ": outputs: " + open.front(), NumberAt(*first, open.front()).error(),
                  study.cases.front());
}

}  // namespace phs::sweep
