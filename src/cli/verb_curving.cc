// phs curving: the steady state in curves of many radii, found directly.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/axle_words.h"
#include "base/progress.h"
#include "base/result_dir.h"
#include "cli/number_within.h"
#include "cli/result_checks.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "jobs/curving_job.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct CurvingVerb {
  CommonOptions common;
  jobs::CurvingRequest request;
  ResultChecks checks;
};

std::string Cell(const Json& row, const char* key, double scale, int decimals) {
  if (!row.contains(key) || !row[key].is_number()) return "-";
  return fmt::format("{:.{}f}", scale * row[key].get<double>(), decimals);
}

/// "4.609 outer".
std::string Attack(const Json& row) {
  const char* key = "angle_of_attack_lead_rad";
  if (!row.contains(key) || !row[key].is_number()) return "-";
  const double angle = row[key].get<double>();
  return fmt::format("{:.3f} {}", 1e3 * std::abs(angle),
                     RailPointedTo(angle, HandOf(row["hand"].get<std::string>())));
}

void PrintRadius(const Json& row) {
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

void PrintHead(const std::string& bogie, bool time_run) {
  fmt::print(
      "{}\n{:>8}{:>8}{:>7}{:>14}{:>11}{:>11}{:>11}{}\n{:>8}{:>8}{:>7}{:>14}{:>11}{:>11}{:>11}{}\n",
      bogie, "R", "speed", "cant", "attack", "largest Y", "sum Y", "T-gamma",
      time_run ? fmt::format("{:>11}{:>9}", "off time", "faster") : "", "m", "km/h", "mm",
      "lead, mrad", "kN", "lead, kN", "all, N",
      time_run ? fmt::format("{:>11}{:>9}", "run, %", "times") : "");
}

/// What limits are held against: for each bogie `curves.rRADIUS` with the numbers of its row.
std::vector<analysis::NamedSummary> Checked(const Json& json) {
  std::vector<analysis::NamedSummary> results;
  for (const auto& [bogie, rows] : json["bogies"].items()) {
    Json of = {{"status", "ok"}, {"reason", ""}, {"curves", Json::array()}};
    for (Json row : rows) {
      row["name"] = fmt::format("r{:g}", row["radius_m"].get<double>());
      if (row["status"] != "ok") {
        of["status"] = row["status"];
        of["reason"] = row["reason"];
      }
      of["curves"].push_back(std::move(row));
    }
    results.emplace_back(bogie, std::move(of));
  }
  return results;
}

int RunCurving(CurvingVerb verb) {
  if (Status s = verb.checks.Read(); !s.ok()) return BadInput(s.error());
  auto asked = OpenAskedDir(verb.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const bool text = verb.common.format == "text";
  bool first = true;
  const jobs::CurvingTeller tell = {.begin =
                                        [&](const std::string& bogie) {
                                          if (text && !first) fmt::print("\n");
                                          if (text) PrintHead(bogie, verb.request.time_run);
                                          first = false;
                                        },
                                    .row =
                                        [&](const Json& row) {
                                          if (text) PrintRadius(row);
                                        }};
  const auto solved =
      jobs::SolveCurves(verb.request, {.stopped = [] { return StopSignal() != 0; }}, tell);
  if (StopSignal() != 0) return Stopped("nothing written");
  if (!solved.ok()) return BadInput(solved.error());
  if (!text) fmt::print("{}\n", solved.value().dump(2));
  if (dir) {
    if (Status s = jobs::WriteCurves(solved.value(), &*dir); !s.ok()) return BadInput(s.error());
    if (Status s = CommitAndTell(verb.common, &*dir); !s.ok()) return BadInput(s.error());
  }
  return verb.checks.Conclude("curving", Checked(solved.value()), kDone);
}

}  // namespace

void AddCurving(CLI::App* verb, Action* action) {
  auto o = std::make_shared<CurvingVerb>();
  o->request.scenario.name = "curving";
  AddCommonOptions(verb, &o->common);
  o->checks.AddOptions(verb);
  verb->add_option("--bogies", o->request.bogies, "Bogies, separated by commas")
      ->delimiter(',')
      ->required();
  verb->add_option("--radii", o->request.radii,
                   "Radii in m, separated by commas; default 150 … 1500")
      ->delimiter(',');
  AddTrackOption(verb, &o->request.track,
                 "Track that gives gauge and friction instead of the bogie's own; without --radii "
                 "its first arc is solved");
  verb->add_option("--speed-limit", o->request.speed_limit_km_h, "km/h")->capture_default_str();
  verb->add_option("--cant", o->request.largest_cant_m,
                   "Largest cant, m; default 0.060 on 1067 mm, wider in proportion")
      ->check(NumberWithin(0.0, 0.2));
  verb->add_option("--deficiency", o->request.deficiency_m,
                   "Cant deficiency, m; default 0.045 on 1067 mm, wider in proportion")
      ->check(NumberWithin(-0.1, 0.2));
  AddFrictionOption(verb, &o->request.scenario.friction);
  AddTimestepOption(verb, &o->request.scenario.timestep_s);
  verb->add_option("--vehicle", o->request.scenario.vehicle, "bogie or locomotive")
      ->check(CLI::IsMember({"bogie", "locomotive"}));
  verb->add_flag("--time-run", o->request.time_run,
                 "Run each curve in time too: difference and time saved");
  verb->callback([=] { *action = [=] { return RunCurving(*o); }; });
}

}  // namespace phs::cli
