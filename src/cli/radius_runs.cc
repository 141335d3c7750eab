// phs compare --radii: several bogies in several curves.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/critical_speeds.h"
#include "analysis/pair_conicity.h"
#include "base/result_dir.h"
#include "cli/curve_options.h"
#include "cli/radius_table.h"
#include "report/radius_report.h"
#include "vehicle/radius_table.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;
using vehicle::Scenario;

/// Critical speeds of every bogie: {bogie: {linear_m_s, nonlinear_m_s, …}}.
Result<Json> CriticalSpeedsOf(const CurveOptions& options, const Scenario& base) {
  ProgressLine progress("critical speeds", options.common.quiet);
  Json all = Json::object();
  const double count = static_cast<double>(options.bogies.size());
  for (const std::string& bogie : options.bogies) {
    Scenario own = base;
    vehicle::UseBogie(bogie, &own);
    const double before = static_cast<double>(all.size()) / count;
    auto speeds = analysis::FindCriticalSpeeds(
        own, [&](double share) { return progress(before + share / count); });
    if (!speeds.ok()) return speeds.error();
    all[vehicle::BogieLabel(bogie)] = analysis::CriticalSpeedsJson(speeds.value());
  }
  return all;
}

/// The conicity of every bogie's wheels and rails: {bogie: …}. It is the same in all curves.
Result<Json> ConicityOf(const std::vector<std::string>& bogies, const Scenario& curve) {
  Json all = Json::object();
  for (const std::string& bogie : bogies) {
    Scenario own = curve;
    vehicle::UseBogie(bogie, &own);
    const auto simulation = vehicle::Simulation::Create(own);
    if (!simulation.ok()) return simulation.error();
    all[vehicle::BogieLabel(bogie)] =
        analysis::ConicityJson(analysis::CalcConicity(simulation.value()));
  }
  return all;
}

}  // namespace

int RunOverRadii(const CurveOptions& options) {
  if (options.checks.asked()) {
    return BadInput({"--check, --junit", "are for one curve", "compare without --radii", ""});
  }
  if (!options.track.empty()) {
    return BadInput({"--track", "is for one curve", "compare without --radii", ""});
  }
  if (options.verify) {
    return BadInput({"--verify", "is for one curve", "compare without --radii", ""});
  }
  auto loaded = LoadCurve(options);
  if (!loaded.ok()) return BadInput(loaded.error());
  const Scenario base = std::move(loaded).value();
  std::vector<Scenario> curves;
  for (const int radius : options.radii_m) {
    auto curve = vehicle::ScenarioOfRadius(base, radius);
    if (!curve.ok()) return BadInput(curve.error());
    curves.push_back(std::move(curve).value());
  }
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  ProgressLine progress(base.name, options.common.quiet);
  auto rows =
      vehicle::RunRadii(curves, options.bogies, [&](double share) { return progress(share); });
  if (!rows.ok()) return BadInput(rows.error());
  if (StopSignal() != 0) return Stopped("nothing written");
  Json described = vehicle::DescribeRadii(rows.value(), base);
  auto conicity = ConicityOf(options.bogies, curves.front());
  if (!conicity.ok()) return BadInput(conicity.error());
  described["conicity"] = std::move(conicity).value();
  if (options.stability) {
    auto speeds = CriticalSpeedsOf(options, base);
    if (!speeds.ok()) return BadInput(speeds.error());
    described["critical_speeds"] = std::move(speeds).value();
  }
  if (options.common.format == "json") {
    fmt::print("{}\n", described.dump(2));
  } else {
    fmt::print("{}", RadiusTable(described));
  }
  if (dir) {
    const Status s = Publish(options.common, "bogies.json", described.dump(2) + "\n",
                             &report::WriteRadiusReport, &*dir);
    if (!s.ok()) return BadInput(s.error());
  }
  for (const auto& row : rows.value()) {
    if (row.summary.status != "ok") return kFailed;
  }
  return kDone;
}

}  // namespace phs::cli
