#include "cli/curve_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/axle_words.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

double NumberOf(const Json& value) {
  return value.is_number() ? value.get<double>() : std::nan("");
}

/// Value at a JSON pointer, NaN if absent.
double At(const Json& summary, const std::string& pointer) {
  const Json::json_pointer p(pointer);
  return summary.contains(p) ? NumberOf(summary.at(p)) : std::nan("");
}

/// A figure of one wheel or wheelset by its name.
double Named(const Json& summary, const std::string& list, const std::string& name,
             const std::string& key) {
  if (!summary.contains("steady_curve")) return std::nan("");
  for (const Json& item : summary["steady_curve"][list]) {
    if (item["name"] == name) return NumberOf(item[key]);
  }
  return std::nan("");
}

double SumOverWheels(const Json& summary, const std::string& key) {
  if (!summary.contains("steady_curve")) return std::nan("");
  double sum = 0;
  for (const Json& wheel : summary["steady_curve"]["wheels"]) sum += NumberOf(wheel[key]);
  return sum;
}

/// Name of the foremost wheelset: "lead", or "front_lead" on a locomotive.
std::string Foremost(const Json& summary) {
  if (!summary.contains("steady_curve")) return "lead";
  return summary["steady_curve"]["wheelsets"][0]["name"].get<std::string>();
}

struct Row {
  std::string label;
  std::string unit;
  int decimals;
  double scale;
  bool ratio;
  std::function<double(const Json&)> value;
  bool attack = false;  ///< an angle of attack: its magnitude and where the axle points
  bool steady = true;   ///< a mean over the steady curve, not of the whole run
};

/// +1 in a left-hand curve, -1 in a right-hand one, 0 without.
int Hand(const Json& summary) {
  const double radius = At(summary, "/steady_curve/radius_m");
  return std::isfinite(radius) ? (radius > 0 ? 1 : -1) : 0;
}

std::vector<Row> Rows() {
  const auto wheelset = [](const char* key, bool last) {
    return [key, last](const Json& s) {
      std::string name = Foremost(s);
      if (last) name.replace(name.size() - 4, 4, "trail");
      return Named(s, "wheelsets", name, key);
    };
  };
  const auto wheel = [](const char* which, const char* key) {
    return [which, key](const Json& s) { return Named(s, "wheels", Foremost(s) + which, key); };
  };
  const auto of_run = [](const char* key) {
    return [key](const Json& s) { return At(s, std::string("/run/") + key); };
  };
  return {
      {"angle of attack, lead", "mrad", 3, 1e3, true, wheelset("angle_of_attack_rad", false), true},
      {"angle of attack, trail", "mrad", 3, 1e3, true, wheelset("angle_of_attack_rad", true), true},
      {"lateral position, lead", "mm", 2, 1e3, false, wheelset("lateral_m", false)},
      {"lateral position, trail", "mm", 2, 1e3, false, wheelset("lateral_m", true)},
      {"Y, lead outer wheel", "kN", 2, 1e-3, true, wheel("_outer", "Y_N")},
      {"Y, lead inner wheel", "kN", 2, 1e-3, true, wheel("_inner", "Y_N")},
      {"Q, lead outer wheel", "kN", 2, 1e-3, true, wheel("_outer", "Q_N")},
      {"Y/Q, lead outer wheel", "-", 4, 1, true, wheel("_outer", "Y_over_Q")},
      {"sum Y, lead axle", "kN", 2, 1e-3, true, wheelset("sum_Y_N", false)},
      {"T-gamma, lead outer wheel", "N", 1, 1, true, wheel("_outer", "T_gamma_N")},
      {"T-gamma, all wheels", "N", 1, 1, true,
       [](const Json& s) { return SumOverWheels(s, "T_gamma_N"); }},
      {"bending of the bogie", "mrad", 3, 1e3, false,
       [](const Json& s) {
         const double single = At(s, "/steady_curve/bending_rad");
         return std::isnan(single) ? At(s, "/steady_curve/front_bending_rad") : single;
       }},
      {"largest Y/Q of the run", "-", 4, 1, true, of_run("max_Y_over_Q"), false, false},
      {"T-gamma over the run", "kJ", 2, 1e-3, true, of_run("T_gamma_total_J"), false, false},
      {"energy error of the run", "%", 4, 1e2, false, of_run("energy_error_relative"), false,
       false},
      {"times real time (one core)", "-", 1, 1, false,
       [](const Json& s) { return At(s, "/real_time_factor"); }, false, false},
  };
}

std::string Cell(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : std::string("-");
}

std::string CellOf(const Row& row, const Json& summary) {
  const double value = row.value(summary) * row.scale;
  if (!row.attack || !std::isfinite(value)) return Cell(value, row.decimals);
  return Cell(std::abs(value), row.decimals) + " " + RailPointedTo(value, Hand(summary));
}

/// How many times the number of the first bogie is that of another; angles by their magnitudes.
double Times(const Row& row, const Json& first, const Json& other) {
  const double ratio = row.value(first) / row.value(other);
  return row.attack ? std::abs(ratio) : ratio;
}

/// The run came to the steady curve, over whose place it has means.
bool IsReached(const Json& summary) {
  return std::isfinite(At(summary, "/steady_curve/speed_m_s"));
}

bool AnyReached(const NamedSummaries& summaries) {
  return std::any_of(summaries.begin(), summaries.end(),
                     [](const auto& named) { return IsReached(named.second); });
}

/// Why a run has no means, a line each.
std::string NotReached(const NamedSummaries& summaries) {
  std::string text;
  for (const auto& [name, summary] : summaries) {
    if (IsReached(summary) || !summary.contains("steady_curve")) continue;
    text += fmt::format(
        "! {}: the run ends after {:.4g} s, before its last axle has come to the steady curve: s = "
        "{:.4g} to {:.4g} m, the last third of the first arc, or of a track without one\n",
        name, At(summary, "/run/end_time_s"), At(summary, "/steady_curve/begin_s_m"),
        At(summary, "/steady_curve/end_s_m"));
  }
  return text;
}

/// Of a column headed by the names, at least `least`.
size_t Width(const NamedSummaries& summaries, size_t least) {
  for (const auto& [name, summary] : summaries) least = std::max(least, name.size() + 2);
  return least;
}

}  // namespace

std::string CurveTable(const NamedSummaries& summaries) {
  const bool reached = AnyReached(summaries);
  std::string text =
      fmt::format("{:<30}{:>6}", reached ? "steady curve (mean)" : "whole run", "unit");
  const size_t wide = Width(summaries, 13), ratio = Width(summaries, 13) + 1;
  for (const auto& [name, summary] : summaries) text += fmt::format("{:>{}}", name, wide);
  for (size_t i = 1; i < summaries.size(); ++i) {
    text += fmt::format("{:>{}}", "/" + summaries[i].first, ratio);
  }
  text +=
      '\n' + std::string(36 + wide * summaries.size() + ratio * (summaries.size() - 1), '-') + '\n';
  for (const Row& row : Rows()) {
    if (row.steady && !reached) continue;
    text += fmt::format("{:<30}{:>6}", row.label, row.unit);
    for (const auto& [name, summary] : summaries) {
      text += fmt::format("{:>{}}", CellOf(row, summary), wide);
    }
    for (size_t i = 1; i < summaries.size() && row.ratio; ++i) {
      text += fmt::format("{:>{}}", Cell(Times(row, summaries[0].second, summaries[i].second), 3),
                          ratio);
    }
    text += '\n';
  }
  text += NotReached(summaries);
  for (const auto& [name, summary] : summaries) {
    if (summary["status"] != "ok") {
      text += fmt::format("{}: {}: {}\n", name, summary["status"].get<std::string>(),
                          summary["reason"].get<std::string>());
    }
  }
  return text;
}

std::string SteeringBudget(const NamedSummaries& summaries) {
  if (!AnyReached(summaries)) return "";
  std::string text =
      "Yaw moments on the leading axle, steady curve [kN m] (sum = 0; creep steers it):\n";
  const size_t wide = Width(summaries, 14);
  text += fmt::format("{:<{}}{:>12}{:>14}{:>14}{:>14}\n", "", wide, "wheel-rail", "PHS pressure",
                      "PHS friction", "suspension");
  for (const auto& [name, summary] : summaries) {
    const std::string base = "/budget/" + Foremost(summary) + "/";
    text += fmt::format("{:<{}}{:>12}{:>14}{:>14}{:>14}\n", name, wide,
                        Cell(At(summary, base + "creep_Nm") / 1e3, 3),
                        Cell(At(summary, base + "phs_pressure_Nm") / 1e3, 3),
                        Cell(At(summary, base + "phs_friction_Nm") / 1e3, 3),
                        Cell(At(summary, base + "primary_Nm") / 1e3, 3));
  }
  return text;
}

}  // namespace phs::cli
