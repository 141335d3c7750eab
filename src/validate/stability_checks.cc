// Linear stability beside published critical speeds.
#include "analysis/stability.h"
#include "validate/check.h"
#include "vehicle/simulation.h"

namespace phs::validate {

Status AddStabilityChecks(Checks* checks) {
  vehicle::Scenario scenario;
  scenario.name = "stability";
  scenario.track = "straight";
  scenario.bogie = "cooperrider";
  scenario.speed_m_s = 60;
  scenario.timestep_s = 1e-4;  // the wheels' springs are stiff; the analysis itself takes no step
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const auto result = analysis::AnalyseStability(&simulation.value(), {50, 90, 9});
  if (!result.ok()) return result.error();
  constexpr double kPublished = 68.66;
  checks->push_back({.group = {},
                     .what = "linear critical speed of the Cooperrider bogie, built as MJCF",
                     .unit = "m/s",
                     .ours = result.value().critical_speed,
                     .reference = kPublished,
                     .tolerance = 1e-3 * kPublished,
                     .claim = Claim::kNear,
                     .source = "B. Hassard, bifurcation.de/exd10, of Kaas-Petersen, Acta Mechanica "
                               "61 (1986) 89",
                     .skipped = {}});
  return {};
}

}  // namespace phs::validate
