#include "sweep/study_case.h"

#include <algorithm>
#include <cmath>

#include "analysis/axle_modes_json.h"
#include "analysis/load_cases.h"
#include "analysis/running_assessment.h"
#include "analysis/stability.h"
#include "analysis/steady_curve.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::sweep {
namespace {

using Json = nlohmann::ordered_json;

Result<Analysed> RunInTime(vehicle::Simulation* simulation) {
  const auto outcome = simulation->Run();
  if (!outcome.ok()) return outcome.error();
  Json numbers = vehicle::Summarise(*simulation, outcome.value());
  numbers["assessment"] = analysis::AssessRun(*simulation, outcome.value());
  return Analysed{outcome.value().status, outcome.value().reason, std::move(numbers)};
}

Result<Analysed> SolveCurve(vehicle::Simulation* simulation) {
  const auto solved = analysis::SolveSteadyCurve(simulation);
  if (!solved.ok()) return solved.error();
  const Json& steady = solved.value().steady;
  return Analysed{.numbers = {{"steady_curve", steady}, {"totals", analysis::CurveTotals(steady)}}};
}

Result<Analysed> FindCriticalSpeed(vehicle::Simulation* simulation) {
  analysis::StabilityOptions options;
  options.speeds = 24;  // from 5 to 120 m/s: branches closer than 5 m/s are seen as one
  const auto found = analysis::AnalyseStability(simulation, options);
  if (!found.ok()) return found.error();
  const double critical = found.value().critical_speed;
  const bool unstable_at_once = found.value().spectra.front().growth > 0;
  const double up_to = unstable_at_once       ? 0
                       : std::isnan(critical) ? options.max_speed_m_s
                                              : critical;
  Json numbers;
  numbers["critical_speed_m_s"] = std::isnan(critical) ? Json(nullptr) : Json(critical);
  numbers["stable_up_to_m_s"] = up_to;
  return Analysed{.numbers = numbers};
}

Result<Analysed> MeasureModes(const vehicle::Simulation& simulation) {
  const analysis::AxleModeOptions options;
  const auto modes = analysis::MeasureAxleModes(simulation, options);
  if (!modes.ok()) return modes.error();
  return Analysed{.numbers =
                      analysis::AxleModesJson(simulation.scenario().bogie, modes.value(), options)};
}

Result<Analysed> LayLoads(const vehicle::Simulation& simulation) {
  const auto results = analysis::CalcLoadCases(simulation, analysis::StandardLoadCases());
  if (!results.ok()) return results.error();
  return Analysed{.numbers = analysis::LoadsJson(simulation, results.value())};
}

}  // namespace

Analysis ReadAnalysis(YamlMap* map) {
  static const std::vector<std::string> kWords = {"simulate", "curving", "stability", "modes",
                                                  "loads"};
  const std::string word = map->Word("analysis", kWords, "simulate");
  return static_cast<Analysis>(std::find(kWords.begin(), kWords.end(), word) - kWords.begin());
}

std::vector<std::string> DefaultOutputs(Analysis analysis) {
  std::vector<std::string> steady = {"steady_curve.wheelsets.lead.angle_of_attack_rad",
                                     "steady_curve.wheelsets.trail.angle_of_attack_rad",
                                     "steady_curve.wheelsets.lead.lateral_m",
                                     "steady_curve.wheels.lead_outer.Y_N",
                                     "steady_curve.wheels.lead_outer.Y_over_Q",
                                     "steady_curve.wheels.lead_outer.T_gamma_N"};
  const auto with = [&](std::initializer_list<const char*> more) {
    steady.insert(steady.end(), more.begin(), more.end());
    return steady;
  };
  switch (analysis) {
    case Analysis::kSimulate:
      return with({"run.T_gamma_total_J", "run.max_Y_over_Q", "run.max_sum_Y_N",
                   "run.max_angle_of_attack_rad", "run.energy_error_relative"});
    case Analysis::kCurving:
      return with({"totals.T_gamma_N", "totals.largest_Y_N", "totals.largest_Y_over_Q"});
    case Analysis::kStability:
      return {"stable_up_to_m_s"};
    case Analysis::kModes:
      return {"bending.stiffness_Nm_per_rad", "shear.stiffness_Nm_per_rad",
              "traction.stiffness_N_per_m", "antiphase.stiffness_N_per_m"};
    case Analysis::kLoads:
      return {"cases.traction, electric braking.largest_shift_m",
              "cases.traction, electric braking.least_pressure_Pa", "cases.braking.largest_shift_m",
              "cases.braking.largest_cylinder_N"};
  }
  return {};
}

Result<Analysed> Analyse(Analysis analysis, const vehicle::Scenario& scenario) {
  vehicle::Scenario own = scenario;
  // The linear analysis takes no step; a small one passes the check of stiffness.
  if (analysis == Analysis::kStability) own.timestep_s = 1e-4;
  auto simulation = vehicle::Simulation::Create(own);
  if (!simulation.ok()) return simulation.error();
  switch (analysis) {
    case Analysis::kSimulate:
      return RunInTime(&simulation.value());
    case Analysis::kCurving:
      return SolveCurve(&simulation.value());
    case Analysis::kStability:
      return FindCriticalSpeed(&simulation.value());
    case Analysis::kModes:
      return MeasureModes(simulation.value());
    case Analysis::kLoads:
      return LayLoads(simulation.value());
  }
  return Error{"analysis", "is unknown", "", ""};
}

}  // namespace phs::sweep
