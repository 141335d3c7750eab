#include "cli/assessment_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/assessed_quantities.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;
using report::AssessedName;

const Json* Assessed(const Json& summary) {
  if (!summary.contains("assessment") || summary["assessment"]["status"] != "ok") return nullptr;
  return &summary["assessment"];
}

/// Value with "!" where the limit is missed.
std::string LimitCell(const Json& assessment, const AssessedName& q) {
  if (!assessment["worst"].contains(q.key)) return "-";
  const Json& worst = assessment["worst"][q.key];
  return fmt::format("{:.{}f}{}", q.scale * worst["value"].get<double>(), q.decimals,
                     worst["kept"].get<bool>() ? " " : "!");
}

/// Limit of the first summary that has the quantity; curves of several radii differ in Y_qst.
std::string LimitOf(const NamedSummaries& summaries, const AssessedName& q) {
  for (const auto& [name, summary] : summaries) {
    const Json* a = Assessed(summary);
    if (a == nullptr || !(*a)["worst"].contains(q.key)) continue;
    return fmt::format("{:.{}f}", q.scale * (*a)["worst"][q.key]["limit"].get<double>(),
                       q.decimals);
  }
  return "";
}

/// Largest of the sections' accelerations [m/s^2].
std::string Ride(const Json& assessment, const char* axis) {
  double largest = std::nan("");
  for (const Json& section : assessment["sections"]) {
    if (!section["ride"].contains(axis)) continue;
    const Json& r = section["ride"][axis];
    largest = std::fmax(largest, std::fmax(std::abs(r["low_m_s2"].get<double>()),
                                           std::abs(r["high_m_s2"].get<double>())));
  }
  return std::isfinite(largest) ? fmt::format("{:.3f} ", largest) : "-";
}

/// "3 mild, 1 severe".
std::string Regimes(const Json& assessment) {
  std::string text;
  for (const char* regime : {"mild", "severe", "catastrophic"}) {
    int count = 0;
    for (const Json& wheel : assessment["wheels"]) {
      count += wheel.contains("steady_wear_regime") && wheel["steady_wear_regime"] == regime;
    }
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, regime);
  }
  return text;
}

double LargestOf(const Json& assessment, const char* key) {
  double largest = std::nan("");
  for (const Json& wheel : assessment["wheels"]) {
    if (wheel.contains(key) && wheel[key].is_number()) {
      largest = std::fmax(largest, wheel[key].get<double>());
    }
  }
  return largest;
}

std::string WearLines(const NamedSummaries& summaries) {
  std::string text =
      "wear of the wheels (steady curve: BRR regimes, rail fatigue per axle pass; run: worst "
      "wheel)\n";
  for (const auto& [name, summary] : summaries) {
    const Json* a = Assessed(summary);
    if (a == nullptr) continue;
    const double damage = LargestOf(*a, "steady_rcf_damage_per_pass");
    text += fmt::format("  {:<19}{:<42}RCF {}  {:.2g} mm2/km\n", name, Regimes(*a),
                        std::isfinite(damage) ? fmt::format("{:.1e}", damage) : "-",
                        LargestOf(*a, "worn_area_mm2_per_km"));
  }
  return text;
}

}  // namespace

std::string AssessmentTable(const NamedSummaries& summaries) {
  const Json* first = nullptr;
  for (const auto& [name, summary] : summaries) {
    if (first == nullptr) first = Assessed(summary);
  }
  if (first == nullptr) return "";
  std::string text = fmt::format("{:<30}{:>6}{:>9}", "EN 14363 / UIC 518, worst", "unit", "limit");
  size_t width = 13;
  for (const auto& [name, summary] : summaries) width = std::max(width, name.size() + 2);
  for (const auto& [name, summary] : summaries) text += fmt::format("{:>{}}", name, width);
  text += '\n' + std::string(45 + width * summaries.size(), '-') + '\n';
  const auto row = [&](const char* label, const char* unit, const std::string& limit,
                       const auto& cell) {
    text += fmt::format("{:<30}{:>6}{:>9}", label, unit, limit);
    for (const auto& [name, summary] : summaries) {
      const Json* a = Assessed(summary);
      text += fmt::format("{:>{}}", a == nullptr ? std::string("-") : cell(*a), width);
    }
    text += '\n';
  };
  for (const AssessedName& q : report::AssessedNames()) {
    const std::string limit = LimitOf(summaries, q);
    if (!limit.empty()) row(q.label, q.unit, limit, [&](const Json& a) { return LimitCell(a, q); });
  }
  row("body acceleration, lateral", "m/s2", "", [](const Json& a) { return Ride(a, "lateral"); });
  row("body acceleration, vertical", "m/s2", "", [](const Json& a) { return Ride(a, "vertical"); });
  if ((*first)["limits_are_orientation"].get<bool>()) {
    text += fmt::format(
        "limits made for 1435 mm and 22.5 t: orientation on {:.0f} mm and {:.1f} t; ! = beyond\n",
        1e3 * (*first)["gauge_m"].get<double>(),
        (*first)["static_wheel_load_N"].get<double>() * 2 / 9810);
  }
  return text + WearLines(summaries);
}

}  // namespace phs::cli
