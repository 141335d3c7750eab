#include "cli/run_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "vehicle/discretisation.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMostNamed = 8;  ///< other numbers that move, by name

/// A headline number; FOREMOST in its name stands for the leading wheelset, LAST for the trailing
/// one of the same bogie.
struct RemarkRow {
  const char* label;
  const char* name;
};

const RemarkRow kRows[] = {
    {"angle of attack, lead", "steady_curve.wheelsets.FOREMOST.angle_of_attack_rad"},
    {"angle of attack, trail", "steady_curve.wheelsets.LAST.angle_of_attack_rad"},
    {"lateral position, lead", "steady_curve.wheelsets.FOREMOST.lateral_m"},
    {"lateral position, trail", "steady_curve.wheelsets.LAST.lateral_m"},
    {"Y, lead outer wheel", "steady_curve.wheels.FOREMOST_outer.Y_N"},
    {"Y, lead inner wheel", "steady_curve.wheels.FOREMOST_inner.Y_N"},
    {"Q, lead outer wheel", "steady_curve.wheels.FOREMOST_outer.Q_N"},
    {"Y/Q, lead outer wheel", "steady_curve.wheels.FOREMOST_outer.Y_over_Q"},
    {"sum Y, lead axle", "steady_curve.wheelsets.FOREMOST.sum_Y_N"},
    {"T-gamma, lead outer wheel", "steady_curve.wheels.FOREMOST_outer.T_gamma_N"},
    {"T-gamma, all wheels", "steady_curve.T_gamma_N"},
    {"bending of the bogie", "steady_curve.BOGIEbending_rad"},
    {"largest Y/Q of the run", "run.max_Y_over_Q"},
    {"T-gamma over the run", "run.T_gamma_total_J"}};

void Replace(const std::string& what, const std::string& by, std::string* text) {
  const size_t at = text->find(what);
  if (at != std::string::npos) text->replace(at, what.size(), by);
}

/// The name of a row's number in one summary.
std::string NameOf(const RemarkRow& row, const Json& summary) {
  std::string foremost = "lead";
  if (summary.contains("steady_curve")) {
    foremost = summary["steady_curve"]["wheelsets"][0]["name"].get<std::string>();
  }
  const std::string bogie =
      foremost.ends_with("lead") ? foremost.substr(0, foremost.size() - 4) : "";
  std::string name = row.name;
  Replace("FOREMOST", foremost, &name);
  Replace("LAST", bogie + "trail", &name);
  Replace("BOGIE", bogie, &name);
  return name;
}

std::string ChangeCell(const Json& discretisation, const std::string& name) {
  const Json& changes = discretisation["changes"];
  if (!changes.contains(name)) return "-";
  const double change = vehicle::JudgedChange(changes[name]);
  if (!std::isfinite(change)) return "-";
  const bool of_scale = changes[name]["of_scale"].is_number();
  const Json& moving = discretisation["moving"];
  const bool moves = std::find(moving.begin(), moving.end(), name) != moving.end();
  return fmt::format("{}{:+.2f} %{}", moves ? "! " : "", change * 100, of_scale ? " *" : "  ");
}

/// Numbers beyond 2 % that no row of the table shows.
std::string OthersThatMove(const std::string& bogie, const Json& discretisation,
                           const std::set<std::string>& shown) {
  std::vector<std::string> others;
  for (const Json& name : discretisation["moving"]) {
    if (!shown.contains(name.get<std::string>())) others.push_back(name);
  }
  if (others.empty()) return "";
  std::string text = fmt::format("! {}: {} more beyond 2 %:", bogie, others.size());
  for (size_t i = 0; i < std::min(others.size(), kMostNamed); ++i) {
    const double change = vehicle::JudgedChange(discretisation["changes"][others[i]]);
    text += fmt::format("{} {} {:+.1f} %", i > 0 ? "," : "", others[i], change * 100);
  }
  return text + (others.size() > kMostNamed ? ", …\n" : "\n");
}

}  // namespace

std::string DiscretisationTable(const NamedSummaries& summaries, const Json& ratios) {
  size_t wide = 16;
  for (const auto& [name, summary] : summaries) {
    if (!summary.contains("discretisation")) return "";
    wide = std::max(wide, name.size() + 2);
  }
  const Json& first = summaries.front().second["discretisation"];
  std::string text = fmt::format("{:<36}", fmt::format("at {:g} ms against {:g} ms step",
                                                       first["timestep_s"].get<double>() * 1e3,
                                                       first["half_step_s"].get<double>() * 1e3));
  for (const auto& [name, summary] : summaries) text += fmt::format("{:>{}}", name, wide);
  text += '\n' + std::string(36 + wide * summaries.size(), '-') + '\n';
  std::string others;
  for (const RemarkRow& row : kRows) {
    text += fmt::format("{:<36}", row.label);
    for (const auto& [name, summary] : summaries) {
      text +=
          fmt::format("{:>{}}", ChangeCell(summary["discretisation"], NameOf(row, summary)), wide);
    }
    text += '\n';
  }
  for (const auto& [name, summary] : summaries) {
    std::set<std::string> shown;
    for (const RemarkRow& row : kRows) shown.insert(NameOf(row, summary));
    others += OthersThatMove(name, summary["discretisation"], shown);
    if (summary["discretisation"]["half_step_status"] != "ok") {
      others += fmt::format("! {}: the run with half the step ended as '{}'\n", name,
                            summary["discretisation"]["half_step_status"].get<std::string>());
    }
  }
  if (ratios.is_object()) others += OthersThatMove("ratios", ratios, {});
  return text + "* of the largest magnitude in the run, since the number changes sign\n" + others;
}

std::string WarningLines(const NamedSummaries& summaries) {
  std::string text;
  for (const auto& [name, summary] : summaries) {
    for (const Json& warning : summary.value("warnings", Json::array())) {
      text += fmt::format("! {}: {}\n", name, warning["text"].get<std::string>());
    }
    if (!summary.contains("run")) continue;
    const Json& error = summary["run"]["energy_error_relative"];
    if (error.is_number() && std::abs(error.get<double>()) > vehicle::kEnergyErrorShare) {
      text += fmt::format("! {}: energy error {:.2f} % (beyond 0.1 %)\n", name,
                          error.get<double>() * 100);
    }
  }
  return text;
}

}  // namespace phs::cli
