#include "jobs/loads_job.h"

#include "analysis/plain_track.h"
#include "base/origin.h"

namespace phs::jobs {

Result<Loads> CalcLoads(vehicle::Scenario scenario) {
  const auto track = analysis::StraightTrack::For(scenario.bogie, scenario.track);
  if (!track.ok()) return track.error();
  scenario.track = track.value().name();
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  auto results = analysis::CalcLoadCases(simulation.value(), analysis::StandardLoadCases());
  if (!results.ok()) return results.error();
  auto json = analysis::LoadsJson(simulation.value(), results.value());
  return Loads{std::move(simulation).value(), std::move(results).value(), std::move(json)};
}

Status WriteLoads(const Loads& loads, ResultDir* dir) {
  if (Status s = WriteOrigin(dir->File("")); !s.ok()) return s;
  return WriteFileAtomically(dir->File("loads.json"), loads.json.dump(2) + "\n");
}

}  // namespace phs::jobs
