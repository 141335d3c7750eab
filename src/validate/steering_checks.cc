// Steering bogies: what their makers and the thesis say of them. None of it was measured, so all of
// it is orientation.
#include <cmath>
#include <string>

#include "analysis/load_cases.h"
#include "validate/check_groups.h"
#include "vehicle/radius_table.h"

namespace phs::validate {
namespace {

using Json = nlohmann::ordered_json;

vehicle::Scenario Dry() {
  vehicle::Scenario s;
  s.name = "validate";
  s.wheel = "S1002";
  s.rail = "UIC60";
  s.creep = "kalker_table";
  s.friction.tread = 0.35;
  return s;
}

double Number(const Json& row, const char* key) {
  return row[key].is_number() ? row[key].get<double>() : std::nan("");
}

/// Rows of three bogies in two curves: emd_radial, phs, rigid_link at 300 m, then at 550 m.
Result<Json> RunCurves() {
  const vehicle::Scenario base = Dry();
  std::vector<vehicle::Scenario> curves;
  for (const int radius : {300, 550}) {
    auto curve = vehicle::ScenarioOfRadius(base, radius);
    if (!curve.ok()) return curve.error();
    curves.push_back(std::move(curve).value());
  }
  auto rows = vehicle::RunRadii(curves, {"emd_radial", "phs", "rigid_link"}, {});
  if (!rows.ok()) return rows.error();
  return vehicle::DescribeRadii(rows.value(), base)["rows"];
}

void AddCurves(const Json& rows, Checks* checks) {
  const auto attack = [&](int row) {
    return std::abs(Number(rows[static_cast<size_t>(row)], "angle_of_attack_lead_rad"));
  };
  checks->push_back({.what = "EMD radial: angle of attack over rigid, mean of R = 300, 550 m",
                     .unit = "-",
                     .ours = (attack(0) / attack(2) + attack(3) / attack(5)) / 2,
                     .reference = 1.0 / 3,
                     .claim = Claim::kOrientation,
                     .source = "Swenson 1999: less than one third of conventional"});
  for (const int row : {1, 4}) {
    checks->push_back(
        {.what = row == 1 ? "PHS: wear of the rigid bogie over own, R = 300 m"
                          : "PHS: wear of the rigid bogie over own, R = 550 m",
         .unit = "-",
         .ours = Number(rows[static_cast<size_t>(row)], "wear_yardstick_over_own_run"),
         .reference = 7,
         .claim = Claim::kOrientation,
         .source = "DCD 2012 (ADAMS/Rail, never validated): almost factor 7"});
  }
}

Status AddLoads(Checks* checks) {
  vehicle::Scenario standing = Dry();
  standing.track = "straight";
  standing.speed_m_s = 20;
  auto simulation = vehicle::Simulation::Create(standing);
  if (!simulation.ok()) return simulation.error();
  auto results = analysis::CalcLoadCases(simulation.value(), analysis::StandardLoadCases());
  if (!results.ok()) return results.error();
  const auto largest = [&](size_t i) {
    double force = 0;
    for (const double f : results.value()[i].end.force_N) force = std::max(force, std::abs(f));
    return force / 1e3;
  };
  checks->push_back({.what = "cylinder force under steering loads, 30 kN per box",
                     .unit = "kN",
                     .ours = largest(0),
                     .reference = 30,
                     .claim = Claim::kOrientation,
                     .source = "thesis ch. 4: below 30 kN in normal use"});
  checks->push_back({.what = "cylinder force under traction, 52 kN per box",
                     .unit = "kN",
                     .ours = largest(1),
                     .reference = 60,
                     .claim = Claim::kOrientation,
                     .source = "thesis ch. 4: 60 kN largest working load"});
  return {};
}

}  // namespace

Status AddSteeringChecks(Checks* checks) {
  auto rows = RunCurves();
  if (!rows.ok()) return rows.error();
  AddCurves(rows.value(), checks);
  return AddLoads(checks);
}

}  // namespace phs::validate
