// phs loads: the loads of the thesis's table on the axle boxes, and which part gives first.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/load_cases.h"
#include "analysis/plain_track.h"
#include "base/result_dir.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "vehicle/simulation.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct LoadsOptions {
  CommonOptions common;
  vehicle::Scenario scenario;
};

void Print(const analysis::LoadResult& result, const hydraulics::PhsSystem& system) {
  fmt::print("\n{}: {:.1f} kN per box, {}\n", result.load_case.name, result.load_case.load_N / 1e3,
             result.load_case.pattern);
  fmt::print("  axles move {:.2f} mm (lead), {:.2f} mm (trail), yaw {:.2f}, {:.2f} mrad\n",
             result.end.x_m[0] * 1e3, result.end.x_m[1] * 1e3, result.end.yaw_rad[0] * 1e3,
             result.end.yaw_rad[1] * 1e3);
  fmt::print("  cylinders [kN]:");
  for (size_t i = 0; i < result.end.force_N.size(); ++i) {
    fmt::print("  {}: {:.1f}", system.cylinder_names()[i], result.end.force_N[i] / 1e3);
  }
  fmt::print("\n  lines [MPa]:   ");
  for (size_t i = 0; i < result.end.pressure_Pa.size(); ++i) {
    fmt::print("  {}: {:.2f}", system.line_names()[i], result.end.pressure_Pa[i] / 1e6);
  }
  fmt::print("\n");
  if (result.limits.empty()) fmt::print("  no limit reached\n");
  for (const auto& limit : result.limits) {
    fmt::print("  from {:6.1f} kN per box: {}\n", limit.load_N / 1e3, limit.what);
  }
}

int RunLoads(const LoadsOptions& options) {
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  vehicle::Scenario scenario = options.scenario;
  const auto track = analysis::StraightTrack::For(scenario.bogie, scenario.track);
  if (!track.ok()) return BadInput(track.error());
  scenario.track = track.value().name();
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return BadInput(simulation.error());
  auto results = analysis::CalcLoadCases(simulation.value(), analysis::StandardLoadCases());
  if (!results.ok()) return BadInput(results.error());
  const hydraulics::PhsSystem& system = *simulation.value().binding().phs()[0].system;
  const Json json = analysis::LoadsJson(simulation.value(), results.value());
  if (options.common.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{} with {}: longitudinal loads on every axle box, settled\n",
               options.scenario.bogie, system.name());
    for (const auto& result : results.value()) Print(result, system);
  }
  if (!dir) return kDone;
  if (Status s = WriteFileAtomically(dir->File("loads.json"), json.dump(2) + "\n"); !s.ok()) {
    return BadInput(s.error());
  }
  const Status s = dir->Commit();
  return s.ok() ? kDone : BadInput(s.error());
}

}  // namespace

void AddLoads(CLI::App* verb, Action* action) {
  auto options = std::make_shared<LoadsOptions>();
  options->scenario.speed_m_s = 20;
  AddCommonOptions(verb, &options->common);
  verb->add_option("--bogie", options->scenario.bogie, "Bogie: a name or an MJCF file")
      ->capture_default_str();
  verb->add_option("--phs", options->scenario.phs, "PHS model, instead of the bogie's");
  AddTrackOption(verb, &options->scenario.track,
                 "Track that gives the gauge; default straight track as wide as the bogie's own");
  AddTimestepOption(verb, &options->scenario.timestep_s);
  verb->callback([=] { *action = [=] { return RunLoads(*options); }; });
}

}  // namespace phs::cli
