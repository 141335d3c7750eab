#include "sweep/output_check.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "analysis/running_assessment.h"
#include "base/json_path.h"
#include "base/local_folder.h"
#include "sweep/case_files.h"
#include "sweep/study_case.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kInterval = 0.01;  ///< [s]
constexpr double kBeyond = 40;      ///< the whole vehicle is off both ends of the track [m]
constexpr int kMostRows = 100'000;
constexpr int kMostVehicles = 20;

/// A run of two rows made to cover the whole track, so that every quantity there can be is there.
/// Only the names of its numbers mean something. Forces swing, or nothing would be said of hunting.
vehicle::RunOutcome Stretched(const vehicle::Simulation& simulation, vehicle::RunOutcome run) {
  const double length = simulation.binding().track().length() + 2 * kBeyond;
  const double speed =
      std::max(simulation.binding().target_speed(), length / (kMostRows * kInterval));
  const int rows = static_cast<int>(length / (speed * kInterval)) + 1;
  for (std::size_t c = 0; c < run.columns.size(); ++c) {
    const double value = run.columns[c].front();
    const bool swings = run.channels[c].name.ends_with("_Y_N");
    run.columns[c].resize(static_cast<std::size_t>(rows));
    for (int i = 0; i < rows; ++i) {
      const double t = i * kInterval;
      const std::string& name = run.channels[c].name;
      run.columns[c][static_cast<std::size_t>(i)] =
          name == "t_s"   ? t
          : name == "s_m" ? speed * t - kBeyond
                          : value + (swings ? 1e3 * std::sin(2 * M_PI * 5 * t) : 0);
    }
  }
  return run;
}

/// The numbers of one run by name; their values mean nothing. Nothing where it cannot be told.
std::optional<Json> NumbersOf(const Study& study, int run) {
  const LocalFolder scratch;
  const auto file = WriteCaseFiles(study, run, scratch.path());
  if (!file.ok()) return std::nullopt;
  auto scenario = vehicle::LoadScenario(file.value());
  if (!scenario.ok()) return std::nullopt;
  const Analysis analysis = study.CaseOf(run).analysis;
  if (analysis != Analysis::kSimulate) {
    const auto made = Analyse(analysis, scenario.value());
    return made.ok() ? std::optional(made.value().numbers) : std::nullopt;
  }
  const double step = scenario.value().timestep_s;  // 0: the bogie's own
  scenario.value().duration_s = 2 * (step > 0 ? step : vehicle::kDefaultStep_s);
  auto simulation = vehicle::Simulation::Create(scenario.value());
  if (!simulation.ok()) return std::nullopt;
  auto short_run = simulation.value().Run();
  if (!short_run.ok() || short_run.value().columns[0].empty()) return std::nullopt;
  Json numbers = vehicle::Summarise(simulation.value(), short_run.value());
  const bool assessed = std::any_of(study.outputs.begin(), study.outputs.end(),
                                    [](const auto& o) { return o.starts_with("assessment."); });
  if (assessed) {
    numbers["assessment"] = analysis::AssessRun(
        simulation.value(), Stretched(simulation.value(), std::move(short_run).value()));
  }
  return numbers;
}

/// What tells one vehicle of a study from another: the words among a run's values, and its case.
std::string VehicleOf(const Study& study, int run) {
  std::string words = std::to_string(
      study.case_of_run.empty() ? 0 : study.case_of_run[static_cast<std::size_t>(run)]);
  for (std::size_t i = 0; i < study.axes.size(); ++i) {
    for (const char* key : {"scenario.bogie", "scenario.vehicle", "scenario.phs"}) {
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
  Error error = NumberAt(*first, open.front()).error();
  error.where = study.path + ": outputs: " + open.front();
  return error;
}

}  // namespace phs::sweep
