#include "jobs/stability_job.h"

#include "analysis/critical_speeds.h"
#include "analysis/plain_track.h"
#include "analysis/stability_json.h"
#include "base/origin.h"
#include "report/analysis_report.h"

namespace phs::jobs {
namespace {

/// The vehicle for time runs, at a step given or chosen.
Result<vehicle::Simulation> ForTimeRuns(const StabilityRequest& request, double largest_step) {
  if (!(request.timestep_s > 0)) return analysis::CreateForRamps(request.scenario, largest_step);
  vehicle::Scenario scenario = request.scenario;
  scenario.timestep_s = request.timestep_s;
  return vehicle::Simulation::Create(scenario);
}

}  // namespace

Result<Stability> AnalyseStability(const StabilityRequest& asked, const Watch& watch,
                                   const Watch& watch_ramp) {
  StabilityRequest request = asked;
  request.scenario.speed_m_s = 20;
  const auto track = analysis::StraightTrack::For(request.scenario.bogie, request.scenario.track);
  if (!track.ok()) return track.error();
  request.scenario.track = track.value().name();
  // The linear analysis takes no step; a small one passes the check of stiffness.
  request.scenario.timestep_s = 1e-4;
  auto simulation = vehicle::Simulation::Create(request.scenario);
  if (!simulation.ok()) return simulation.error();
  auto result = analysis::AnalyseStability(&simulation.value(), request.scan,
                                           [&](double share) { return watch.GoesOn(share); });
  if (!result.ok()) return result.error();
  Stability stability{std::move(result).value(), {}, {}, request.cycle, {}};
  stability.json = analysis::StabilityJson(simulation.value(), stability.linear);
  if (request.map) {
    auto map = analysis::FindHuntingMap(&simulation.value(), stability.linear.mode, request.balance,
                                        [&](double share) { return watch.GoesOn(share); });
    if (!map.ok()) return map.error();
    stability.map = std::move(map).value();
    stability.json["hunting_map"] = analysis::HuntingMapJson(stability.map, request.balance);
  }
  if (!request.ramp) return stability;
  stability.ramp = analysis::ChooseRamp(request.scan, stability.linear, request.cycle);
  auto runs = ForTimeRuns(request, simulation.value().largest_stable_step());
  if (!runs.ok()) return runs.error();
  auto found = analysis::FindLimitCycle(&runs.value(), stability.linear.mode, stability.ramp,
                                        [&](double share) { return watch_ramp.GoesOn(share); });
  if (!found.ok()) return found.error();
  stability.cycle = std::move(found).value();
  stability.json["limit_cycle"] = analysis::LimitCycleJson(*stability.cycle, stability.ramp);
  return stability;
}

Status WriteStability(const Stability& stability, ResultDir* dir) {
  const std::string file = dir->File("stability.json");
  if (Status s = WriteFileAtomically(file, stability.json.dump(2) + "\n"); !s.ok()) return s;
  if (Status s = WriteOrigin(dir->File("")); !s.ok()) return s;
  return report::WriteStabilityReport(file, dir->File("report.html"));
}

}  // namespace phs::jobs
