#include "report/result_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <limits>

#include "base/table.h"
#include "base/words.h"
#include "report/alarms_report.h"
#include "report/analysis_report.h"
#include "report/curving_report.h"
#include "report/identify_report.h"
#include "report/json_fields.h"
#include "report/optimisation_report.h"
#include "report/page_links.h"
#include "report/radius_report.h"
#include "report/readable_name.h"
#include "report/report_page.h"
#include "report/rig_report.h"
#include "report/study_report.h"

namespace phs::report {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void Append(const std::string& part, std::string* text) {
  if (!part.empty()) *text += (text->empty() ? "" : "; ") + part;
}

double At(const json& object, const char* pointer) {
  const json::json_pointer at(pointer);
  return object.contains(at) ? AsNumber(object.at(at)) : std::nan("");
}

/// "T-gamma 5.4 kJ"; empty for no number.
std::string Named(const std::string& words, double value, const char* unit) {
  if (!std::isfinite(value)) return "";
  return words + " " + FormatNumber(value) + (*unit == '\0' ? "" : " ") + unit;
}

/// Counts what did not end well: "2 of 9 not ok (derailed)".
void TellStates(const std::vector<std::string>& states, ResultSummary* told) {
  std::string other;
  size_t good = 0;
  for (const std::string& state : states) {
    if (state == "ok") {
      ++good;
    } else if (other.find(state) == std::string::npos) {
      Append(state, &other);
    }
  }
  told->bad = good < states.size();
  told->status =
      !told->bad ? "ok"
                 : fmt::format("{} of {} not ok ({})", states.size() - good, states.size(), other);
  if (states.size() == 1 && told->bad) told->status = other;
}

std::string RunNumbers(const json& run) {
  std::vector<std::string> parts;
  const json sets = run.value("steady_curve", json::object()).value("wheelsets", json::array());
  if (!sets.empty()) {
    const double attack = 1e3 * std::abs(NumberOf(sets[0], "angle_of_attack_rad"));
    parts.push_back(Named("angle of attack of the leading axle", attack, "mrad"));
  }
  parts.push_back(Named("T-gamma", 1e-3 * At(run, "/run/T_gamma_total_J"), "kJ"));
  parts.push_back(Named("Y/Q at most", At(run, "/run/max_Y_over_Q"), ""));
  std::erase(parts, "");
  return JoinWords(parts);
}

/// One line of the numbers of a bogie.
void AppendLine(const std::string& bogie, const std::string& numbers, std::string* text) {
  *text += (text->empty() ? "" : "\n") + bogie + (numbers.empty() ? "" : ": ") + numbers;
}

void TellComparison(const json& all, ResultSummary* told) {
  std::vector<std::string> states;
  for (const auto& [name, run] : all.at("bogies").items()) {
    states.push_back(run.value("status", "?"));
    AppendLine(name, states.back() == "ok" ? RunNumbers(run) : states.back(), &told->numbers);
  }
  TellStates(states, told);
}

void TellRun(const json& run, ResultSummary* told) {
  TellStates({run.value("status", "?")}, told);
  AppendLine(run.value("bogie", "bogie"), RunNumbers(run), &told->numbers);
}

void TellRadii(const json& all, ResultSummary* told) {
  std::vector<std::string> states, bogies;
  double least = kInfinity, most = 0;
  for (const json& row : all.at("rows")) {
    states.push_back(row.value("status", "?"));
    const std::string bogie = row.value("bogie", "?");
    if (std::find(bogies.begin(), bogies.end(), bogie) == bogies.end()) bogies.push_back(bogie);
    const double radius = NumberOf(row, "radius_m");
    least = std::min(least, radius), most = std::max(most, radius);
  }
  TellStates(states, told);
  told->numbers = JoinWords(bogies) + fmt::format("; {} runs, R {} to {} m", states.size(),
                                                  FormatNumber(least), FormatNumber(most));
}

void TellCurving(const json& all, ResultSummary* told) {
  std::vector<std::string> states;
  for (const auto& [name, rows] : all.at("bogies").items()) {
    const json* tightest = nullptr;
    for (const json& row : rows) {
      states.push_back(row.value("status", "?"));
      const bool tighter =
          tightest == nullptr || NumberOf(row, "radius_m") < NumberOf(*tightest, "radius_m");
      if (states.back() == "ok" && tighter) tightest = &row;
    }
    std::vector<std::string> parts;
    if (tightest != nullptr) {
      parts = {Named("at R", NumberOf(*tightest, "radius_m"), "m"),
               Named("angle of attack of the leading axle",
                     1e3 * std::abs(NumberOf(*tightest, "angle_of_attack_lead_rad")), "mrad"),
               Named("T-gamma", NumberOf(*tightest, "T_gamma_N"), "N")};
      std::erase(parts, "");
    }
    AppendLine(name, JoinWords(parts), &told->numbers);
  }
  TellStates(states, told);
}

void TellModes(const json& modes, ResultSummary* told) {
  told->status = "ok";
  told->numbers = modes.value("bogie", "");
  for (const char* mode : {"bending", "shear"}) {
    Append(Named(mode, 1e-6 * NumberOf(modes.value(mode, json::object()), "stiffness_Nm_per_rad"),
                 "MN m/rad"),
           &told->numbers);
  }
  Append(
      Named("traction",
            1e-6 * NumberOf(modes.value("traction", json::object()), "stiffness_N_per_m"), "MN/m"),
      &told->numbers);
}

void TellStability(const json& all, ResultSummary* told) {
  told->status = "ok";
  told->numbers = all.value("bogie", "");
  const double linear = 3.6 * NumberOf(all, "critical_speed_m_s");
  Append(std::isfinite(linear) ? Named("linear critical speed", linear, "km/h")
                               : "no linear critical speed in the range",
         &told->numbers);
  const double cycle = 3.6 * At(all, "/limit_cycle/nonlinear_critical_speed_m_s");
  Append(Named("non-linear critical speed", cycle, "km/h"), &told->numbers);
}

void TellLoads(const json& loads, ResultSummary* told) {
  told->status = "ok";
  told->numbers = loads.value("bogie", "");
  const json cases = loads.value("cases", json::array());
  if (!cases.empty()) Append(fmt::format("{} load cases", cases.size()), &told->numbers);
}

void TellValidation(const json& all, ResultSummary* told) {
  told->status = all.value("status", "?");
  told->bad = told->status != "ok";
  told->numbers = fmt::format(
      "{} checks hold, {} failed, {} missed and listed", FormatNumber(NumberOf(all, "passed")),
      FormatNumber(NumberOf(all, "failed")), FormatNumber(NumberOf(all, "missed_and_listed")));
}

/// The channel with the largest error, before and after where there are both.
void TellErrors(const json& channels, ResultSummary* told) {
  std::string worst;
  double largest = -1;
  for (const auto& [name, scores] : channels.items()) {
    const double after = At(scores, scores.contains("after") ? "/after/nrmse" : "/nrmse");
    if (after > largest) largest = after, worst = name;
  }
  if (worst.empty()) return;
  const double before = At(channels.at(worst), "/before/nrmse");
  Append(fmt::format(
             "error of {}{}: {} % of its standard deviation{}", Readable(worst).words,
             channels.size() > 1 ? fmt::format(" (worst of {} channels)", channels.size()) : "",
             FormatNumber(100 * largest),
             std::isfinite(before)
                 ? fmt::format(", {} % as declared and fitted", FormatNumber(100 * before))
                 : ""),
         &told->numbers);
}

void TellRig(const json& result, ResultSummary* told) {
  const bool identified = result.contains("effects");
  told->kind = identified ? "Identification" : "Rig";
  told->numbers = result.value("rig", "") + " rig, " + result.value("declared", "");
  TellErrors(result.value("channels", json::object()), told);
  told->status = "ok";
  if (!identified) return;
  std::vector<std::string> effects;
  for (const json& effect : result["effects"]) effects.push_back(effect.value("name", "?"));
  const std::string verdict = result.value("verdict", "");
  told->bad = verdict == "not_described";
  told->status = result.value(
      "verdict_text", effects.empty() ? "no effect needed" : "needed: " + JoinWords(effects));
}

void TellOptimum(const json& all, ResultSummary* told) {
  const json best = all.value("best", json());
  const bool kept = best.is_object() && best.value("keeps_constraints", false);
  told->bad = !kept;
  told->status = kept ? "ok" : "no design keeps all constraints";
  told->numbers = all.value("study", "");
  Append(fmt::format("{} candidates", FormatNumber(NumberOf(all, "candidates"))), &told->numbers);
  if (best.is_object())
    Append(Named("best objective", NumberOf(best, "objective"), ""), &told->numbers);
}

void TellAlarms(const json& all, ResultSummary* told) {
  told->status = all.value("status", "?");
  told->bad = told->status != "ok";
  told->numbers = fmt::format("{} hoses", all.at("hoses").size());
  Append(fmt::format("{} false alarms in {} km", FormatNumber(At(all, "/false_alarms/count")),
                     FormatNumber(At(all, "/false_alarms/distance_km"))),
         &told->numbers);
}

void TellStudy(const json& all, ResultSummary* told) {
  told->status = all.value("status", "?");
  told->bad = told->status != "ok";
  told->numbers = all.value("study", "");
  Append(all.value("question", ""), &told->numbers);
}

Status RemakeRig(const std::string& folder, const MakeReplay&) {
  const auto file = [&](const char* name) {
    const std::string path = (fs::path(folder) / name).string();
    return fs::exists(path) ? path : std::string();
  };
  const std::string page = (fs::path(folder) / kReportName).string();
  const Result<json> result = ReadJsonObject(file("result.json"));
  if (!result.ok()) return result.error();
  const bool identified = result.value().contains("effects");
  if (!identified && (result.value().contains("rows") || file("measured.csv").empty())) {
    return WriteRigReport({.result = file("result.json"),
                           .predicted = file("predicted.csv"),
                           .measured = file("measured.csv")},
                          page);
  }
  return WriteIdentifyReport({.result = file("result.json"),
                              .measured = file("measured.csv"),
                              .predicted = file("predicted.csv"),
                              .baseline = identified ? file("baseline.csv") : ""},
                             page);
}

Status RemakeCurving(const std::string& folder, const MakeReplay& replay) {
  const std::string page = (fs::path(folder) / kReportName).string();
  if (!replay) return WriteCurvingReport(folder, page);
  const Replay film = replay(folder);
  return WriteCurvingReport(folder, page, &film);
}

Status RemakeModes(const std::string& folder, const MakeReplay&) {
  std::vector<std::string> files;
  for (int i = 0;; ++i) {
    const std::string name = i == 0 ? "modes.json" : fmt::format("modes_{}.json", i);
    const fs::path file = fs::path(folder) / name;
    if (!fs::exists(file)) break;
    files.push_back(file.string());
  }
  return WriteModesReport(files, (fs::path(folder) / kReportName).string());
}

template <Status (*Write)(const std::string&, const std::string&)>
Status RemakeFrom(const std::string& folder, const char* file) {
  return Write((fs::path(folder) / file).string(), (fs::path(folder) / kReportName).string());
}

constexpr ResultKind kKinds[] = {
    {"compare.json", "bogies", "Comparison", &TellComparison, &RemakeCurving},
    {"summary.json", "status", "Run", &TellRun, &RemakeCurving},
    {"bogies.json", "rows", "Bogies over radii", &TellRadii,
     [](const std::string& f, const MakeReplay&) {
       return RemakeFrom<&WriteRadiusReport>(f, "bogies.json");
     }},
    {"curving.json", "bogies", "Curving over radius", &TellCurving,
     [](const std::string& f, const MakeReplay&) {
       return RemakeFrom<&WriteSteadyCurvingReport>(f, "curving.json");
     }},
    {"modes.json", "bending", "Axle modes", &TellModes, &RemakeModes},
    {"stability.json", "eigenvalues", "Stability", &TellStability,
     [](const std::string& f, const MakeReplay&) {
       return RemakeFrom<&WriteStabilityReport>(f, "stability.json");
     }},
    {"result.json", "rig", "Rig", &TellRig, &RemakeRig},
    {"optimum.json", "best", "Best design", &TellOptimum,
     [](const std::string& f, const MakeReplay&) {
       return WriteOptimisationReport(f, (fs::path(f) / kReportName).string());
     }},
    {"alarms.json", "hoses", "Alarms", &TellAlarms,
     [](const std::string& f, const MakeReplay&) {
       return RemakeFrom<&WriteAlarmsReport>(f, "alarms.json");
     }},
    {"study.json", "parts", "Study", &TellStudy,
     [](const std::string& f, const MakeReplay&) {
       return WriteStudyReport(f, (fs::path(f) / kReportName).string());
     }},
    {"loads.json", "cases", "Load cases", &TellLoads, nullptr},
    {"validate.json", "checks", "Validation", &TellValidation, nullptr},
};
}  // namespace

std::span<const ResultKind> ResultKinds() { return kKinds; }

void TellSweep(const std::string& table, ResultSummary* told) {
  told->kind = "Sweep";
  const auto read = ReadCsv(table);
  if (!read.ok()) {
    told->bad = true;
    told->status = "cannot be read: " + read.error().what;
    return;
  }
  const int at = read.value().Find("status");
  std::vector<std::string> varied;
  for (int i = 0; i < at; ++i) {
    const auto& cells = read.value().text[static_cast<size_t>(i)];
    if (std::adjacent_find(cells.begin(), cells.end(), std::not_equal_to<>()) != cells.end() &&
        read.value().names[static_cast<size_t>(i)] != "run") {
      varied.push_back(Readable(read.value().names[static_cast<size_t>(i)]).words);
    }
  }
  if (at >= 0) TellStates(read.value().text[static_cast<size_t>(at)], told);
  told->numbers = fmt::format("{} runs", read.value().num_rows());
  if (!varied.empty()) told->numbers += " over " + JoinWords(varied);
}

}  // namespace phs::report
