// phs curving: the steady state in curves of many radii, found directly.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/curve_family.h"
#include "analysis/steady_curve.h"
#include "base/axle_words.h"
#include "base/result_dir.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "report/analysis_report.h"
#include "vehicle/compose.h"
#include "vehicle/summary.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDryRail = 0.35;  ///< where neither user nor track says

struct CurvingVerb {
  CommonOptions common;
  vehicle::Scenario scenario;
  std::string track;  ///< gives gauge and friction, without radii its own arc
  std::vector<std::string> bogies;
  std::vector<double> radii;
  double speed_limit_km_h = 80;
  double largest_cant_m = -1;  ///< < 0: the family's
  double deficiency_m = std::numeric_limits<double>::quiet_NaN();
  bool check = false;
};

/// The curves for one bogie: on the gauge of the track asked for, else of the bogie's own.
Result<analysis::CurveFamily> FamilyFor(const CurvingVerb& verb, const std::string& bogie) {
  const std::string own = verb.track.empty() ? vehicle::TrackOf(bogie) : verb.track;
  const auto base = own.empty() ? Result<analysis::TrackBase>(analysis::TrackBase{})
                                : analysis::ReadTrackBase(own);
  if (!base.ok()) return base.error();
  analysis::CurveFamily family = analysis::FamilyOn(base.value());
  if (!std::isfinite(family.base.friction)) family.base.friction = kDryRail;
  family.speed_limit_m_s = verb.speed_limit_km_h / 3.6;
  if (verb.largest_cant_m >= 0) family.largest_cant_m = verb.largest_cant_m;
  if (std::isfinite(verb.deficiency_m)) family.deficiency_m = verb.deficiency_m;
  return family;
}

/// The radii to solve for; without any asked for, 0 = the first arc of the track asked for.
std::vector<double> RadiiOf(const CurvingVerb& verb) {
  if (!verb.radii.empty()) return verb.radii;
  if (!verb.track.empty() && analysis::FirstArc(analysis::CurveFamily(), verb.track).ok())
    return {0};
  return {150, 200, 250, 300, 350, 400, 500, 600, 800, 1000, 1500};
}

Json WheelsetOf(const Json& steady, size_t index, const char* key) {
  const Json sets = steady.value("wheelsets", Json::array());
  return index < sets.size() ? sets[index][key] : Json(nullptr);
}

/// Largest difference between the steady state and the time run, each quantity against its scale:
/// angle of attack against a/R of 1.5 m, forces against the static wheel load, shift against 10 mm.
double LargestDifference(const Json& a, const Json& b, double radius, double load) {
  double largest = 0;
  const auto compare = [&](const Json& x, const Json& y, double scale) {
    if (!x.is_number() || !y.is_number()) return;
    largest = std::max(largest, std::abs(x.get<double>() - y.get<double>()) / scale);
  };
  for (size_t i = 0; i < a["wheelsets"].size(); ++i) {
    compare(a["wheelsets"][i]["angle_of_attack_rad"], b["wheelsets"][i]["angle_of_attack_rad"],
            1.5 / radius);
    compare(a["wheelsets"][i]["lateral_m"], b["wheelsets"][i]["lateral_m"], 0.01);
  }
  for (size_t i = 0; i < a["wheels"].size(); ++i) {
    for (const char* key : {"Y_N", "Q_N"}) compare(a["wheels"][i][key], b["wheels"][i][key], load);
  }
  return largest;
}

/// The same curve run through in time: difference and how much longer it takes.
Status AddCheck(vehicle::Simulation* simulation, double radius, double load, double spent,
                Json* row) {
  auto run = simulation->Run();
  if (!run.ok()) return run.status();
  const Json summary = vehicle::Summarise(*simulation, run.value());
  Json& check = (*row)["time_run"];
  check["status"] = summary["status"];
  const double seconds = run.value().end_time_s / run.value().real_time_factor;
  check["faster"] = seconds / spent;
  if (summary["status"] != "ok") return {};
  check["largest_difference"] =
      LargestDifference((*row)["steady_curve"], summary["steady_curve"], radius, load);
  check["steady_curve"] = summary["steady_curve"];
  return {};
}

/// The vehicle on the curve; its track file is gone again.
Result<vehicle::Simulation> OnCurve(const CurvingVerb& verb, const analysis::CurveFamily& family,
                                    const std::string& bogie, bool own_arc,
                                    const analysis::FamilyCurve& curve) {
  vehicle::Scenario scenario = verb.scenario;
  scenario.bogie = bogie;
  scenario.speed_m_s = curve.speed_m_s;
  scenario.track = verb.track;
  if (own_arc) return vehicle::Simulation::Create(scenario);
  const auto track = analysis::TrackOf(family, curve);
  if (!track.ok()) return track.error();
  scenario.track = track.value().path();
  return vehicle::Simulation::Create(scenario);
}

Result<Json> SolveOne(const CurvingVerb& verb, const std::string& bogie, double asked) {
  const auto family = FamilyFor(verb, bogie);
  if (!family.ok()) return family.error();
  const bool own_arc = asked == 0;
  const auto curve = own_arc ? analysis::FirstArc(family.value(), verb.track)
                             : analysis::CurveOfRadius(family.value(), asked);
  if (!curve.ok()) return curve.error();
  const double radius = curve.value().radius_m;
  auto simulation = OnCurve(verb, family.value(), bogie, own_arc, curve.value());
  if (!simulation.ok()) return simulation.error();
  Json row = {{"radius_m", radius},
              {"speed_m_s", curve.value().speed_m_s},
              {"cant_m", curve.value().cant_m},
              {"gauge_m", family.value().base.gauge_m},
              {"status", "ok"},
              {"reason", ""}};
  auto solved = analysis::SolveSteadyCurve(&simulation.value());
  if (!solved.ok()) {
    row["status"] = "no_steady_state";
    row["reason"] = solved.error().Line();
    return row;
  }
  const Json steady = solved.value().steady;
  row["steady_curve"] = steady;
  row["angle_of_attack_lead_rad"] = WheelsetOf(steady, 0, "angle_of_attack_rad");
  row["sum_Y_lead_N"] = WheelsetOf(steady, 0, "sum_Y_N");
  const Json totals = analysis::CurveTotals(steady);
  row["largest_Y_N"] = totals["largest_Y_N"];
  row["T_gamma_N"] = totals["T_gamma_N"];
  row["coasting_m_s2"] = solved.value().coasting_m_s2;
  row["residual"] = solved.value().residual;
  row["evaluations"] = solved.value().evaluations;
  row["processor_s"] = solved.value().processor_s;
  const mjModel* m = simulation.value().model();
  const double load = m->body_subtreemass[0] * 9.81 / (2.0 * steady["wheelsets"].size());
  if (verb.check) {
    if (Status s = AddCheck(&simulation.value(), radius, load, solved.value().processor_s, &row);
        !s.ok()) {
      return s.error();
    }
  }
  return row;
}

std::string Cell(const Json& row, const char* key, double scale, int decimals) {
  if (!row.contains(key) || !row[key].is_number()) return "-";
  return fmt::format("{:.{}f}", scale * row[key].get<double>(), decimals);
}

/// "4.609 outer": the curves of the family are left-hand.
std::string Attack(const Json& row) {
  const char* key = "angle_of_attack_lead_rad";
  if (!row.contains(key) || !row[key].is_number()) return "-";
  const double angle = row[key].get<double>();
  return fmt::format("{:.3f} {}", 1e3 * std::abs(angle), RailPointedTo(angle, 1));
}

void PrintRow(const Json& row) {
  fmt::print("{:>8.0f}{:>8.1f}{:>7.0f}{:>14}{:>11}{:>11}{:>11}", row["radius_m"].get<double>(),
             3.6 * row["speed_m_s"].get<double>(), 1e3 * row["cant_m"].get<double>(), Attack(row),
             Cell(row, "largest_Y_N", 1e-3, 2), Cell(row, "sum_Y_lead_N", 1e-3, 2),
             Cell(row, "T_gamma_N", 1, 1));
  if (row.contains("time_run")) {
    const Json& check = row["time_run"];
    fmt::print("{:>11}{:>9}", Cell(check, "largest_difference", 100, 2),
               Cell(check, "faster", 1, 0));
    if (check["status"] != "ok") fmt::print("  time run: {}", check["status"].get<std::string>());
  }
  if (row["status"] != "ok") fmt::print("  {}", row["status"].get<std::string>());
  fmt::print("\n");
}

void PrintHead(const std::string& bogie, bool check) {
  fmt::print(
      "{}\n{:>8}{:>8}{:>7}{:>14}{:>11}{:>11}{:>11}{}\n{:>8}{:>8}{:>7}{:>14}{:>11}{:>11}{:>11}{}\n",
      bogie, "R", "speed", "cant", "attack", "largest Y", "sum Y", "T-gamma",
      check ? fmt::format("{:>11}{:>9}", "off time", "faster") : "", "m", "km/h", "mm",
      "lead, mrad", "kN", "lead, kN", "all, N",
      check ? fmt::format("{:>11}{:>9}", "run, %", "times") : "");
}

int RunCurving(CurvingVerb verb) {
  auto asked = OpenAskedDir(verb.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const std::vector<double> radii = RadiiOf(verb);
  Json json = {{"bogies", Json::object()}};
  bool failed = false;
  for (const std::string& bogie : verb.bogies) {
    if (verb.common.format == "text") {
      if (!json["bogies"].empty()) fmt::print("\n");
      PrintHead(bogie, verb.check);
    }
    Json& rows = json["bogies"][bogie] = Json::array();
    for (const double radius : radii) {
      auto row = SolveOne(verb, bogie, radius);
      if (!row.ok()) return BadInput(row.error());
      if (verb.common.format == "text") PrintRow(row.value());
      if (row.value()["status"] != "ok") {
        failed = true;
        fmt::print(stderr, "phs: {}\n", row.value()["reason"].get<std::string>());
      }
      rows.push_back(std::move(row).value());
    }
  }
  if (verb.common.format == "json") fmt::print("{}\n", json.dump(2));
  if (dir) {
    const Status s = Publish(verb.common, "curving.json", json.dump(2) + "\n",
                             &report::WriteSteadyCurvingReport, &*dir);
    if (!s.ok()) return BadInput(s.error());
  }
  return failed ? kFailed : kDone;
}

}  // namespace

void AddCurving(CLI::App* verb, Action* action) {
  auto o = std::make_shared<CurvingVerb>();
  o->scenario.name = "curving";
  AddCommonOptions(verb, &o->common);
  verb->add_option("--bogies", o->bogies, "Bogies, separated by commas")
      ->delimiter(',')
      ->required();
  verb->add_option("--radii", o->radii, "Radii in m, separated by commas; default 150 … 1500")
      ->delimiter(',');
  AddTrackOption(verb, &o->track,
                 "Track that gives gauge and friction instead of the bogie's own; without --radii "
                 "its first arc is solved");
  verb->add_option("--speed-limit", o->speed_limit_km_h, "km/h")->capture_default_str();
  verb->add_option("--cant", o->largest_cant_m,
                   "Largest cant, m; default 0.060 on 1067 mm, wider in proportion")
      ->check(CLI::Range(0.0, 0.2));
  verb->add_option("--deficiency", o->deficiency_m,
                   "Cant deficiency, m; default 0.045 on 1067 mm, wider in proportion")
      ->check(CLI::Range(-0.1, 0.2));
  AddFrictionOption(verb, &o->scenario.friction);
  AddTimestepOption(verb, &o->scenario.timestep_s);
  verb->add_option("--vehicle", o->scenario.vehicle, "bogie or locomotive")
      ->check(CLI::IsMember({"bogie", "locomotive"}));
  verb->add_flag("--check", o->check, "Run each curve in time too: difference and time saved");
  verb->callback([=] { *action = [=] { return RunCurving(*o); }; });
}

}  // namespace phs::cli
