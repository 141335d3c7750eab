#include "sweep/run_in_time.h"

#include <algorithm>
#include <cmath>

#include "analysis/running_assessment_json.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kAssessment[] = "assessment";
constexpr double kInterval = 0.01;  ///< [s]
constexpr double kBeyond = 40;      ///< the whole vehicle is off both ends of the track [m]
constexpr int kMostRows = 100'000;

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

}  // namespace

Result<Analysed> RunInTime(const vehicle::Scenario& scenario) {
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const auto outcome = simulation.value().Run();
  if (!outcome.ok()) return outcome.error();
  Json numbers = vehicle::SummaryJson(vehicle::Summarise(simulation.value(), outcome.value()));
  numbers[kAssessment] =
      analysis::AssessmentJson(analysis::AssessRun(simulation.value(), outcome.value()));
  return Analysed{outcome.value().status, outcome.value().reason, std::move(numbers)};
}

Result<Analysed> NamesOfRun(const vehicle::Scenario& scenario,
                            const std::vector<std::string>& outputs) {
  vehicle::Scenario own = scenario;
  const double step = own.timestep_s;  // 0: the bogie's own
  own.duration_s = 2 * (step > 0 ? step : vehicle::kDefaultStep_s);
  auto simulation = vehicle::Simulation::Create(own);
  if (!simulation.ok()) return simulation.error();
  auto run = simulation.value().Run();
  if (!run.ok()) return run.error();
  if (run.value().columns[0].empty()) return Error{own.bogie, "has no first step", "", ""};
  Json numbers = vehicle::SummaryJson(vehicle::Summarise(simulation.value(), run.value()));
  const bool assessed = std::any_of(outputs.begin(), outputs.end(), [](const std::string& path) {
    return path.starts_with(std::string(kAssessment) + ".");
  });
  if (assessed) {
    numbers[kAssessment] = analysis::AssessmentJson(analysis::AssessRun(
        simulation.value(), Stretched(simulation.value(), std::move(run).value())));
  }
  return Analysed{.numbers = std::move(numbers)};
}

}  // namespace phs::sweep
