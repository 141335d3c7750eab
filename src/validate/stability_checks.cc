// Linear stability beside published critical speeds; axle modes of the PHS beside closed forms.
#include <numbers>

#include "analysis/axle_modes.h"
#include "analysis/stability.h"
#include "validate/check_groups.h"
#include "vehicle/simulation.h"

namespace phs::validate {
namespace {

Status AddModeChecks(Checks* checks) {
  vehicle::Scenario scenario;
  scenario.name = "modes";
  scenario.track = "straight";
  scenario.bogie = "phs_declared";
  scenario.speed_m_s = 20;
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  const auto modes = analysis::MeasureAxleModes(simulation.value());
  if (!modes.ok()) return modes.error();
  // Cylinders 100/32 mm at b = 0.9 m; lines of 1.1 l at 1.4 GPa with 16.16 ml of gas at 1.8 MPa
  // (diagonal) and 2.0 MPa (cross); springs 1.62e6 N m/rad and 2.0e6 N/m per axle; seals 36 MN/m.
  constexpr double b2 = 0.9 * 0.9;
  constexpr double bore = std::numbers::pi / 4 * 0.1 * 0.1;
  constexpr double rod = bore - std::numbers::pi / 4 * 0.032 * 0.032;
  constexpr double diagonal = 1.1e-3 / 1.4e9 + 16.16e-6 / 1.8e6;
  constexpr double cross = 1.1e-3 / 1.4e9 + 16.16e-6 / (1.8e6 * bore / rod);
  constexpr double seals = 4 * 3.6e7;
  const double reference[] = {2 * 1.62e6 + seals * b2,
                              2 * 1.62e6 + seals * b2 + 8 * b2 * bore * bore / diagonal,
                              2 * 2.0e6 + seals + 8 * rod * rod / cross,
                              2 * 2.0e6 + seals + 8 * (rod * rod / cross + bore * bore / diagonal)};
  for (size_t i = 0; i < modes.value().small.size(); ++i) {
    const analysis::AxleMode& mode = modes.value().small[i];
    checks->push_back({.group = {},
                       .what = "axle mode " + mode.name + " of the declared PHS bogie, 0.02 mm",
                       .unit = mode.rotation ? "N m/rad" : "N/m",
                       .ours = mode.stiffness,
                       .reference = reference[i],
                       .tolerance = 2e-3 * reference[i],
                       .claim = Claim::kNear,
                       .source = "closed form: springs, seals that stick, 8 b^2 A_bore^2/C and the "
                                 "like (docs/stability.md)",
                       .skipped = {}});
  }
  return {};
}

}  // namespace

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
  return AddModeChecks(checks);
}

}  // namespace phs::validate
