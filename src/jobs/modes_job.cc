#include "jobs/modes_job.h"

#include <fmt/format.h>

#include "analysis/axle_modes_json.h"
#include "analysis/plain_track.h"
#include "base/origin.h"
#include "report/analysis_report.h"
#include "vehicle/simulation.h"

namespace phs::jobs {

Result<std::vector<MeasuredModes>> MeasureModes(const ModesRequest& request, const Watch& watch) {
  std::vector<std::string> bogies = {request.scenario.bogie};
  bogies.insert(bogies.end(), request.beside.begin(), request.beside.end());
  std::vector<MeasuredModes> all;
  for (const std::string& bogie : bogies) {
    vehicle::Scenario scenario = request.scenario;
    scenario.bogie = bogie;
    if (!all.empty()) scenario.phs.clear();
    const auto track = analysis::StraightTrack::For(bogie, request.scenario.track);
    if (!track.ok()) return track.error();
    scenario.track = track.value().name();
    auto simulation = vehicle::Simulation::Create(scenario);
    if (!simulation.ok()) return simulation.error();
    const double before = static_cast<double>(all.size());
    auto modes = analysis::MeasureAxleModes(simulation.value(), request.measure, [&](double share) {
      return watch.GoesOn((before + share) / static_cast<double>(bogies.size()));
    });
    if (!modes.ok()) return modes.error();
    all.push_back({bogie, std::move(modes).value()});
  }
  return all;
}

nlohmann::ordered_json ModesJson(const MeasuredModes& measured, const ModesRequest& request) {
  return analysis::AxleModesJson(measured.bogie, measured.modes, request.measure);
}

Status WriteModes(const std::vector<MeasuredModes>& all, const ModesRequest& request,
                  ResultDir* dir) {
  std::vector<std::string> files;
  for (const MeasuredModes& measured : all) {
    files.push_back(
        dir->File(files.empty() ? "modes.json" : fmt::format("modes_{}.json", files.size())));
    const std::string text = ModesJson(measured, request).dump(2) + "\n";
    if (Status s = WriteFileAtomically(files.back(), text); !s.ok()) return s;
  }
  if (Status s = WriteOrigin(dir->File("")); !s.ok()) return s;
  return report::WriteModesReport(files, dir->File("report.html"));
}

}  // namespace phs::jobs
