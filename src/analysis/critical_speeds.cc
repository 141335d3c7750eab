#include "analysis/critical_speeds.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/plain_track.h"
#include "phs_model/phs_model.h"

namespace phs::analysis {
namespace {

constexpr double kAbove = 1.2;  ///< begin of the ramp over the linear critical speed
constexpr double kBelow = 1.0 / 6;
constexpr double kScanned_m_s = 20;   ///< any: the linear analysis starts at its own speeds
constexpr double kLinearStep = 1e-4;  ///< passes the check of stiffness; no step is taken [s]
constexpr double kStep = 1e-3;
constexpr double kOfLargestStep = 0.7;
constexpr double kScanShare = 0.2;  ///< of the progress

nlohmann::ordered_json NumberOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

std::string HuntingOf(const LimitCycle& cycle) {
  if (std::isfinite(cycle.critical_speed)) return "dies";
  if (cycle.derailed) return "derailed";
  return cycle.down.size() > 1 ? "lives" : "none";
}

vehicle::Scenario RunningFree(vehicle::Scenario scenario) {
  scenario.speed_m_s = kScanned_m_s;
  scenario.timestep_s = kLinearStep;
  scenario.start_s_m = vehicle::Scenario().start_s_m;
  scenario.duration_s = 0;
  scenario.running = {};
  std::erase_if(scenario.phs_changes.failures,
                [](const phs_model::Failure& f) { return phs_model::HasTime(f) && f.at_s > 0; });
  return scenario;
}

}  // namespace

LimitCycleOptions ChooseRamp(const StabilityOptions& scan, const StabilityResult& result,
                             LimitCycleOptions options) {
  const double centre =
      std::isfinite(result.critical_speed) ? result.critical_speed : scan.max_speed_m_s / kAbove;
  if (!(options.high_speed_m_s > 0)) options.high_speed_m_s = kAbove * centre;
  if (!(options.low_speed_m_s > 0)) options.low_speed_m_s = kBelow * centre;
  return options;
}

Result<vehicle::Simulation> CreateForRamps(vehicle::Scenario scenario, double largest_step) {
  scenario.timestep_s = std::min(kStep, kOfLargestStep * largest_step);
  return vehicle::Simulation::Create(scenario);
}

Result<CriticalSpeeds> FindCriticalSpeeds(const vehicle::Scenario& scenario,
                                          const vehicle::Progress& progress) {
  vehicle::Scenario free = RunningFree(scenario);
  const auto track = StraightTrack::Like(scenario.track);
  if (!track.ok()) return track.error();
  free.track = track.value().name();
  auto simulation = vehicle::Simulation::Create(free);
  if (!simulation.ok()) return simulation.error();
  const auto part = [&](double from, double share) {
    return [&progress, from, share](double done) {
      return !progress || progress(from + share * done);
    };
  };
  const StabilityOptions scan;
  auto linear = AnalyseStability(&simulation.value(), scan, part(0, kScanShare));
  if (!linear.ok()) return linear.error();
  const LimitCycleOptions ramp = ChooseRamp(scan, linear.value(), {});
  auto runs = CreateForRamps(free, simulation.value().largest_stable_step());
  if (!runs.ok()) return runs.error();
  auto cycle =
      FindLimitCycle(&runs.value(), linear.value().mode, ramp, part(kScanShare, 1 - kScanShare));
  if (!cycle.ok()) return cycle.error();
  return CriticalSpeeds{linear.value().critical_speed, cycle.value().critical_speed,
                        HuntingOf(cycle.value()),      cycle.value().amplitude,
                        ramp.high_speed_m_s,           ramp.low_speed_m_s};
}

nlohmann::ordered_json CriticalSpeedsJson(const CriticalSpeeds& s) {
  return {{"linear_m_s", NumberOrNull(s.linear)},
          {"nonlinear_m_s", NumberOrNull(s.nonlinear)},
          {"hunting", s.hunting},
          {"amplitude_m", NumberOrNull(s.amplitude)},
          {"ramp_from_m_s", s.ramp_begin},
          {"ramp_to_m_s", s.ramp_end}};
}

}  // namespace phs::analysis
