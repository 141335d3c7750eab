// phs loads: the loads of the thesis's table on the axle boxes, and which part gives first.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "base/result_dir.h"
#include "cli/result_checks.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "jobs/loads_job.h"

namespace phs::cli {
namespace {

struct LoadsOptions {
  CommonOptions common;
  ResultChecks checks;
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
  fmt::print("\n  lines [MPa absolute]:");
  for (size_t i = 0; i < result.end.pressure_Pa.size(); ++i) {
    fmt::print("  {}: {:.2f}", system.line_names()[i], result.end.pressure_Pa[i] / 1e6);
  }
  fmt::print("\n");
  if (result.limits.empty()) fmt::print("  no limit reached\n");
  for (const auto& limit : result.limits) {
    fmt::print("  from {:6.1f} kN per box: {}\n", limit.load_N / 1e3, limit.what);
  }
}

int RunLoads(LoadsOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const auto loads = jobs::CalcLoads(options.scenario);
  if (!loads.ok()) return BadInput(loads.error());
  const hydraulics::PhsSystem& system = *loads.value().simulation.binding().phs()[0].system;
  if (options.common.format == "json") {
    fmt::print("{}\n", loads.value().json.dump(2));
  } else {
    fmt::print("{} with {}: longitudinal loads on every axle box, settled\n",
               options.scenario.bogie, system.name());
    for (const auto& result : loads.value().results) Print(result, system);
  }
  if (dir) {
    if (Status s = jobs::WriteLoads(loads.value(), &*dir); !s.ok()) return BadInput(s.error());
    if (Status s = dir->Commit(); !s.ok()) return BadInput(s.error());
  }
  return options.checks.Conclude("loads", {{options.scenario.bogie, loads.value().json}}, kDone);
}

}  // namespace

void AddLoads(CLI::App* verb, Action* action) {
  auto options = std::make_shared<LoadsOptions>();
  options->scenario.speed_m_s = 20;
  AddCommonOptions(verb, &options->common);
  options->checks.AddOptions(verb);
  verb->add_option("--bogie", options->scenario.bogie, "Bogie: a name or an MJCF file")
      ->capture_default_str();
  verb->add_option("--phs", options->scenario.phs, "PHS model, instead of the bogie's");
  AddTrackOption(verb, &options->scenario.track,
                 "Track that gives the gauge; default straight track as wide as the bogie's own");
  AddTimestepOption(verb, &options->scenario.timestep_s);
  verb->callback([=] { *action = [=] { return RunLoads(*options); }; });
}

}  // namespace phs::cli
