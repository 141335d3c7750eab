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
#include "cli/verbs.h"
#include "report/analysis_report.h"
#include "vehicle/summary.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CurvingVerb {
  CommonOptions common;
  vehicle::Scenario scenario;
  analysis::CurveFamily family;
  std::vector<std::string> bogies;
  std::vector<double> radii;
  double speed_limit_km_h = 80;
  bool check = false;
};

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

Result<Json> SolveOne(const CurvingVerb& verb, const std::string& bogie, double radius) {
  auto curve = analysis::CurveOfRadius(verb.family, radius);
  if (!curve.ok()) return curve.error();
  auto track = analysis::TemporaryTrack::Write(verb.family, curve.value());
  if (!track.ok()) return track.error();
  vehicle::Scenario scenario = verb.scenario;
  scenario.bogie = bogie;
  scenario.track = track.value().path();
  scenario.speed_m_s = curve.value().speed_m_s;
  auto simulation = vehicle::Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  Json row = {{"radius_m", radius},
              {"speed_m_s", curve.value().speed_m_s},
              {"cant_m", curve.value().cant_m},
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
  verb.family.speed_limit_m_s = verb.speed_limit_km_h / 3.6;
  Json json = {{"bogies", Json::object()}};
  bool failed = false;
  for (const std::string& bogie : verb.bogies) {
    if (verb.common.format == "text") {
      if (!json["bogies"].empty()) fmt::print("\n");
      PrintHead(bogie, verb.check);
    }
    Json& rows = json["bogies"][bogie] = Json::array();
    for (const double radius : verb.radii) {
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

void AddCurving(CLI::App* app, Action* action) {
  CLI::App* verb = app->add_subcommand(
      "curving", "Steady state in curves of many radii, found without running through time");
  auto o = std::make_shared<CurvingVerb>();
  o->scenario.name = "curving";
  o->radii = {150, 200, 250, 300, 350, 400, 500, 600, 800, 1000, 1500};
  AddCommonOptions(verb, &o->common);
  verb->add_option("--bogies", o->bogies, "Bogies, separated by commas")
      ->delimiter(',')
      ->required();
  verb->add_option("--radii", o->radii, "Radii in m, separated by commas")->delimiter(',');
  verb->add_option("--speed-limit", o->speed_limit_km_h, "km/h")->capture_default_str();
  verb->add_option("--cant", o->family.largest_cant_m, "Largest cant, m")->capture_default_str();
  verb->add_option("--deficiency", o->family.deficiency_m, "Cant deficiency, m")
      ->capture_default_str();
  o->scenario.friction.tread = 0.35;
  verb->add_option("--friction", o->scenario.friction, "Wheel-rail friction coefficient")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  verb->add_option("--vehicle", o->scenario.vehicle, "bogie or locomotive")
      ->check(CLI::IsMember({"bogie", "locomotive"}));
  verb->add_flag("--check", o->check, "Run each curve in time too: difference and time saved");
  verb->callback([=] { *action = [=] { return RunCurving(*o); }; });
}

}  // namespace phs::cli
