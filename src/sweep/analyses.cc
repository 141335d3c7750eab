#include "sweep/analyses.h"

#include <cmath>

#include "analysis/axle_modes_json.h"
#include "analysis/critical_speeds.h"
#include "analysis/hunting_map.h"
#include "analysis/last_seconds.h"
#include "analysis/load_cases.h"
#include "analysis/stability.h"
#include "analysis/steady_curve.h"
#include "base/json_path.h"
#include "base/words.h"
#include "sweep/rig_run.h"
#include "sweep/run_in_time.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"
#include "vehicle/summary.h"

namespace phs::sweep {
namespace {

using Json = nlohmann::ordered_json;

Result<Analysed> SolveCurve(const vehicle::Scenario& scenario) {
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const auto solved = analysis::SolveSteadyCurve(&simulation.value());
  if (!solved.ok()) return solved.error();
  const vehicle::SteadyMeans& steady = solved.value().steady;
  const analysis::CurveTotals totals = analysis::CalcCurveTotals(steady);
  return Analysed{.numbers = {{"steady_curve", vehicle::SteadyCurveJson(steady)},
                              {"totals",
                               {{"T_gamma_N", totals.T_gamma_N},
                                {"largest_Y_N", totals.largest_Y_N},
                                {"largest_Y_over_Q", totals.largest_Y_over_Q}}}}};
}

Result<Analysed> FindCriticalSpeed(const vehicle::Scenario& scenario) {
  vehicle::Scenario own = scenario;
  // The linear analysis takes no step; a small one passes the check of stiffness.
  own.timestep_s = 1e-4;
  auto simulation = vehicle::Simulation::Create(own);
  if (!simulation.ok()) return simulation.error();
  analysis::StabilityOptions options;
  options.speeds = 24;  // from 5 to 120 m/s: branches closer than 5 m/s are seen as one
  const auto found = analysis::AnalyseStability(&simulation.value(), options);
  if (!found.ok()) return found.error();
  const double critical = found.value().critical_speed;
  const bool unstable_at_once = found.value().spectra.front().growth > 0;
  const double up_to = unstable_at_once       ? 0
                       : std::isnan(critical) ? options.max_speed_m_s
                                              : critical;
  Json numbers;
  numbers["critical_speed_m_s"] = NumberOrNull(critical);
  numbers["stable_up_to_m_s"] = up_to;
  return Analysed{.numbers = numbers};
}

Analysed HuntingNumbers(double linear, const analysis::HuntingPoint* least,
                        const analysis::HuntingAt& at) {
  return {.numbers = {{"linear_m_s", NumberOrNull(linear)},
                      {"least_speed_m_s", least ? Json(least->speed) : Json(nullptr)},
                      {"least_amplitude_m", least ? Json(least->amplitude) : Json(nullptr)},
                      {"brink_m", NumberOrNull(at.brink)},
                      {"cycle_m", NumberOrNull(at.cycle)}}};
}

Result<Analysed> MapHunting(const vehicle::Scenario& scenario) {
  vehicle::Scenario own = scenario;
  own.timestep_s = 1e-4;  // as in FindCriticalSpeed
  auto simulation = vehicle::Simulation::Create(own);
  if (!simulation.ok()) return simulation.error();
  analysis::StabilityOptions scan;
  scan.speeds = 24;
  const auto linear = analysis::AnalyseStability(&simulation.value(), scan);
  if (!linear.ok()) return linear.error();
  const auto map = analysis::FindHuntingMap(&simulation.value(), linear.value().mode, {});
  if (!map.ok()) return map.error();
  return HuntingNumbers(linear.value().critical_speed, analysis::LeastSpeed(map.value()),
                        analysis::HuntingAtSpeed(map.value(), scenario.speed_m_s));
}

/// Without the map, which takes most of a minute.
Result<Analysed> NamesOfMap(const vehicle::Scenario&, const std::vector<std::string>&) {
  const analysis::HuntingPoint any;
  return HuntingNumbers(0, &any, {});
}

Result<Analysed> RampSpeeds(const vehicle::Scenario& scenario) {
  const auto found = analysis::FindCriticalSpeeds(scenario);
  if (!found.ok()) return found.error();
  return Analysed{.numbers = analysis::CriticalSpeedsJson(found.value())};
}

/// Without the runs, which take half a minute.
Result<Analysed> NamesOfRamps(const vehicle::Scenario&, const std::vector<std::string>&) {
  return Analysed{.numbers = analysis::CriticalSpeedsJson({})};
}

Result<Analysed> MeasureModes(const vehicle::Scenario& scenario) {
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const analysis::AxleModeOptions options;
  const auto modes = analysis::MeasureAxleModes(simulation.value(), options);
  if (!modes.ok()) return modes.error();
  return Analysed{.numbers = analysis::AxleModesJson(simulation.value().scenario().bogie,
                                                     modes.value(), options)};
}

Result<Analysed> LayLoads(const vehicle::Scenario& scenario) {
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const auto results = analysis::CalcLoadCases(simulation.value(), analysis::StandardLoadCases());
  if (!results.ok()) return results.error();
  return Analysed{.numbers = analysis::LoadsJson(simulation.value(), results.value())};
}

Result<Analysed> HoldLoads(const vehicle::Scenario& scenario) {
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const auto held = analysis::CalcHeldShear(simulation.value(), analysis::StandardLoadCases());
  if (!held.ok()) return held.error();
  return Analysed{.numbers = analysis::HeldShearJson(simulation.value(), held.value())};
}

Result<Analysed> RunToItsEnd(const vehicle::Scenario& scenario, double window_s) {
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const auto run = simulation.value().Run();
  if (!run.ok()) return run.error();
  return Analysed{run.value().status,
                  run.value().reason,
                  {{"last", analysis::LastSecondsJson(analysis::CalcLastSeconds(
                                simulation.value(), run.value(), window_s))}}};
}

Result<Analysed> SeeWhatIsLeft(const vehicle::Scenario& scenario) {
  return RunToItsEnd(scenario, analysis::kLastSeconds);
}

Result<Analysed> NamesOfWhatIsLeft(const vehicle::Scenario& scenario,
                                   const std::vector<std::string>&) {
  vehicle::Scenario own = scenario;
  own.duration_s = 0.2;
  return RunToItsEnd(own, 0.05);
}

/// An analysis of a scenario, from its file.
template <Result<Analysed> (*Of)(const vehicle::Scenario&)>
Result<Analysed> OfScenario(const std::string& file) {
  const auto scenario = vehicle::LoadScenario(file);
  if (!scenario.ok()) return scenario.error();
  return Of(scenario.value());
}

template <Result<Analysed> (*Of)(const vehicle::Scenario&, const std::vector<std::string>&)>
Result<Analysed> NamesOfScenario(const std::string& file, const std::vector<std::string>& outputs) {
  const auto scenario = vehicle::LoadScenario(file);
  if (!scenario.ok()) return scenario.error();
  return Of(scenario.value(), outputs);
}

Result<Analysed> DriveOneRig(const std::string& file) {
  auto numbers = CalcRig(file);
  if (!numbers.ok()) return numbers.error();
  return Analysed{.numbers = std::move(numbers).value()};
}

std::vector<Analysis> MakeAnalyses() {
  const auto steady_and = [](std::initializer_list<const char*> more) {
    std::vector<std::string> outputs = {"steady_curve.wheelsets.lead.angle_of_attack_rad",
                                        "steady_curve.wheelsets.trail.angle_of_attack_rad",
                                        "steady_curve.wheelsets.lead.lateral_m",
                                        "steady_curve.wheels.lead_outer.Y_N",
                                        "steady_curve.wheels.lead_outer.Y_over_Q",
                                        "steady_curve.wheels.lead_outer.T_gamma_N"};
    outputs.insert(outputs.end(), more.begin(), more.end());
    return outputs;
  };
  const std::vector<std::string> steady_lists = {"wheelsets", "wheels", "cylinders", "lines"};
  return {
      {"simulate", "the run in time: `summary.json`", "scenario",
       steady_and({"run.T_gamma_total_J", "run.max_Y_over_Q", "run.max_sum_Y_N",
                   "run.max_angle_of_attack_rad", "run.energy_error_relative"}),
       steady_lists, "assessment", &OfScenario<&RunInTime>, &NamesOfScenario<&NamesOfRun>},
      {"curving",
       "the steady state found directly, 20 times faster: `steady_curve.…`, `totals.T_gamma_N`, "
       "`totals.largest_Y_N`, `totals.largest_Y_over_Q`",
       "scenario",
       steady_and({"totals.T_gamma_N", "totals.largest_Y_N", "totals.largest_Y_over_Q"}),
       steady_lists, "", &OfScenario<&SolveCurve>, nullptr},
      {"stability",
       "`critical_speed_m_s`; `stable_up_to_m_s`: the same, or 120 where nothing grows up to there "
       "(scenario on straight track)",
       "scenario",
       {"stable_up_to_m_s"},
       {},
       "",
       &OfScenario<&FindCriticalSpeed>,
       nullptr},
      {"hunting",
       "map of hunting (scenario on straight track): `least_speed_m_s` at which it keeps itself "
       "up, "
       "`least_amplitude_m` there; at the scenario's speed `brink_m`, beyond which a motion grows, "
       "and `cycle_m`",
       "scenario",
       {"linear_m_s", "least_speed_m_s", "least_amplitude_m", "brink_m", "cycle_m"},
       {},
       "",
       &OfScenario<MapHunting>,
       &NamesOfScenario<&NamesOfMap>},
      {"ramps",
       "critical speeds by ramps in time on straight track, as `phs compare --stability`: "
       "`linear_m_s`, `nonlinear_m_s`, below which hunting dies (a scenario's speed does not "
       "count), `amplitude_m` there",
       "scenario",
       {"linear_m_s", "nonlinear_m_s", "amplitude_m"},
       {},
       "",
       &OfScenario<&RampSpeeds>,
       &NamesOfScenario<&NamesOfRamps>},
      {"modes",
       "`modes.json` at 0.5 Hz",
       "scenario",
       {"bending.stiffness_Nm_per_rad", "shear.stiffness_Nm_per_rad", "traction.stiffness_N_per_m",
        "antiphase.stiffness_N_per_m"},
       {},
       "",
       &OfScenario<&MeasureModes>,
       nullptr},
      {"loads",
       "`cases.NAME.…` of `phs loads`: `largest_shift_m`, `least_pressure_Pa`, "
       "`largest_cylinder_N`, …",
       "scenario",
       {"cases.traction, electric braking.largest_shift_m",
        "cases.traction, electric braking.least_pressure_Pa", "cases.braking.largest_shift_m",
        "cases.braking.largest_cylinder_N"},
       {"cases"},
       "",
       &OfScenario<&LayLoads>,
       nullptr},
      {"held",
       "shear stiffness at rest and with the loads of `phs loads` held, seals free: "
       "`rest.shear_stiffness_Nm_per_rad`, `rest.lines.NAME.pressure_Pa`, "
       "`cases.NAME.shear_stiffness_Nm_per_rad`, `cases.NAME.held`, …",
       "scenario",
       {"rest.shear_stiffness_Nm_per_rad",
        "cases.traction, electric braking.shear_stiffness_Nm_per_rad",
        "cases.braking.shear_stiffness_Nm_per_rad"},
       {"cases", "lines"},
       "",
       &OfScenario<&HoldLoads>,
       nullptr},
      {"last_seconds",
       "the run in time, what is left of its motion in the last 10 s: `last.largest_rms_sum_Y_N`, "
       "`last.largest_swing_m`, `last.wheelsets.NAME.…`",
       "scenario",
       {"last.largest_rms_sum_Y_N", "last.largest_swing_m", "last.rms_grows"},
       {"wheelsets"},
       "",
       &OfScenario<&SeeWhatIsLeft>,
       &NamesOfScenario<&NamesOfWhatIsLeft>},
      {"rig",
       "of a study with `rig:`: `result.json` of `phs rig`: `largest.CHANNEL`, `rms.CHANNEL`, "
       "`extremes.CHANNEL.…`, `hydraulic_force.…`, `channels.CHANNEL.…`, `compared_with.CHANNEL.…`",
       "rig",
       {"largest.load_cell_N", "rms.load_cell_N", "extremes.load_cell_N.least",
        "extremes.load_cell_N.most"},
       {},
       "",
       &DriveOneRig,
       nullptr},
  };
}

}  // namespace

std::span<const Analysis> Analyses() {
  static const std::vector<Analysis> analyses = MakeAnalyses();
  return analyses;
}

const Analysis* ReadAnalysis(YamlMap* map, const std::string& of) {
  std::vector<std::string> names, fit;
  for (const Analysis& analysis : Analyses()) {
    names.emplace_back(analysis.name);
    if (analysis.of == of) fit.emplace_back(analysis.name);
  }
  const std::string name = map->Word("analysis", names, fit.front());
  for (const Analysis& analysis : Analyses()) {
    if (analysis.name != name) continue;
    if (analysis.of != of)
      map->Fail("analysis", Quoted(name) + " is none of a " + of, JoinWords(fit));
    return &analysis;
  }
  return &Analyses().front();  // a wrong word is an error of the map
}

bool MayLack(const Analysis& analysis, const std::string& path) {
  const std::string part = analysis.may_lack;
  return !part.empty() && path.starts_with(part + ".");
}

}  // namespace phs::sweep
