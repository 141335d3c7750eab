#include "cli/radius_table.h"

#include <fmt/format.h>

#include <cmath>

#include "base/axle_words.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string RadiusCell(const Json& row, const char* key, double scale, int decimals) {
  if (!row.contains(key) || !row[key].is_number() || !std::isfinite(row[key].get<double>())) {
    return "-";
  }
  return fmt::format("{:.{}f}", row[key].get<double>() * scale, decimals);
}

/// "4.61 outer": magnitude and the rail that the axle points to.
std::string Attack(const Json& row, const char* key) {
  if (!row.contains(key) || !row[key].is_number()) return "-";
  const double angle = row[key].get<double>();
  return fmt::format("{:.2f} {}", 1e3 * std::abs(angle),
                     RailPointedTo(angle, HandOf(row["hand"].get<std::string>())));
}

std::string Line(const Json& row) {
  return fmt::format(
      "  {:<19}{:>13}{:>13}{:>11}{:>11}{:>9}{:>10}{:>10}{:>9}\n", row["bogie"].get<std::string>(),
      Attack(row, "angle_of_attack_lead_rad"), Attack(row, "angle_of_attack_trail_rad"),
      RadiusCell(row, "T_gamma_N", 1, 1), RadiusCell(row, "T_gamma_total_J", 1e-3, 1),
      RadiusCell(row, "wear_yardstick_over_own_run", 1, 2),
      RadiusCell(row, "sum_Y_lead_N", 1e-3, 2), RadiusCell(row, "max_sum_Y_N", 1e-3, 1),
      RadiusCell(row, "max_Y_over_Q", 1, 3));
}

/// Critical speeds on straight track, one line per bogie.
std::string SpeedLines(const Json& speeds) {
  std::string text = fmt::format("critical speed on straight track, km/h\n  {:<19}{:>9}{:>15}\n",
                                 "", "linear", "non-linear");
  for (const auto& [bogie, own] : speeds.items()) {
    const std::string linear =
        own["linear_m_s"].is_number() ? RadiusCell(own, "linear_m_s", 3.6, 0) : "stable";
    const std::string hunting = own["hunting"].get<std::string>();
    const std::string lives = hunting == "dies" ? "from " + RadiusCell(own, "nonlinear_m_s", 3.6, 0)
                              : hunting == "lives"
                                  ? "below " + RadiusCell(own, "ramp_to_m_s", 3.6, 0)
                                  : hunting;
    text += fmt::format("  {:<19}{:>9}{:>15}\n", bogie, linear, lives);
  }
  return text;
}

}  // namespace

std::string RadiusTable(const Json& described) {
  std::string text =
      fmt::format("{:<21}{:>13}{:>13}{:>11}{:>11}{:>9}{:>10}{:>10}{:>9}\n", "", "lead", "trail",
                  "T-gamma,", "T-gamma,", "wear,", "sum Y,", "largest", "largest");
  text += fmt::format("{:<21}{:>13}{:>13}{:>11}{:>11}{:>9}{:>10}{:>10}{:>9}\n", "", "angle",
                      "angle", "steady", "run", "rigid", "lead", "sum Y", "Y/Q");
  text += fmt::format("{:<21}{:>13}{:>13}{:>11}{:>11}{:>9}{:>10}{:>10}{:>9}\n", "bogie", "mrad",
                      "mrad", "N", "kJ", "/own", "kN", "kN", "-");
  std::string block;
  for (const Json& row : described["rows"]) {
    const std::string own =
        fmt::format("R = {:.0f} m, {:.0f} km/h\n", row["radius_m"].get<double>(),
                    row["speed_m_s"].get<double>() * 3.6);
    if (own != block) text += own;
    block = own;
    text += Line(row);
    if (row["status"] != "ok") {
      text += fmt::format("    {}: {}\n", row["status"].get<std::string>(),
                          row["reason"].get<std::string>());
    }
  }
  if (described.contains("critical_speeds")) text += SpeedLines(described["critical_speeds"]);
  return text;
}

}  // namespace phs::cli
