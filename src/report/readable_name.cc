#include "report/readable_name.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace phs::report {
namespace {

struct Unit {
  const char* suffix;
  const char* shown;
  double factor;
};

// Longer names first: sizes of the track and the vehicle stay in metres, strokes become
// millimetres.
constexpr std::array<Unit, 27> kUnits = {
    {{"radius_m", "m", 1},  {"distance_m", "m", 1},  {"wheelbase_m", "m", 1}, {"_s_m", "m", 1},
     {"T_gamma_N", "N", 1}, {"speed_m_s", "m/s", 1}, {"_km_h", "km/h", 1},    {"_m_s2", "m/s²", 1},
     {"_m_s", "mm/s", 1e3}, {"_rad_s", "rad/s", 1},  {"_1_m", "1/m", 1},      {"_1_s", "1/s", 1},
     {"_Nm", "kN m", 1e-3}, {"_kN", "kN", 1},        {"_N", "kN", 1e-3},      {"_MPa", "MPa", 1},
     {"_Pa", "MPa", 1e-6},  {"_mm", "mm", 1},        {"_m3", "cm³", 1e6},     {"_m", "mm", 1e3},
     {"_rad", "mrad", 1e3}, {"_kg", "kg", 1},        {"_J", "kJ", 1e-3},      {"_K", "K", 1},
     {"_percent", "%", 1},  {"_s", "s", 1},          {"_h", "h", 1}}};

constexpr std::array<std::pair<const char*, const char*>, 7> kWords = {
    {{"p_end", "settled pressure"},
     {"p_begin", "pressure just after the step"},
     {"load_cell", "load cell force"},
     {"p_bore", "bore pressure"},
     {"p_rod", "rod pressure"},
     {"piston", "piston displacement"},
     {"actuator", "actuator displacement"}}};

/// "Pas2" → "Pa s²", "m3" → "m³".
std::string Pretty(std::string unit) {
  for (const auto& [from, to] : {std::pair{"Nms", "N m s"}, std::pair{"Nm", "N m"},
                                 std::pair{"Ns", "N s"}, std::pair{"Pas", "Pa s"}}) {
    if (!unit.starts_with(from)) continue;
    unit.replace(0, std::string_view(from).size(), to);
    break;
  }
  for (const auto& [from, to] :
       {std::pair{'2', "²"}, std::pair{'3', "³"}, std::pair{'4', "⁴"}, std::pair{'6', "⁶"}}) {
    if (!unit.empty() && unit.back() == from && unit.size() > 1)
      unit.replace(unit.size() - 1, 1, to);
  }
  return unit;
}

/// Names like "stiffness_N_per_m": the unit is a quotient and is shown as it is.
ReadableName Quotient(const std::string& column, std::size_t per) {
  const std::size_t unit = column.rfind('_', per - 1);
  const std::size_t begin = unit == std::string::npos ? 0 : unit + 1;
  std::string denominator = Pretty(column.substr(per + 5));
  if (denominator.find(' ') != std::string::npos) denominator = "(" + denominator + ")";
  return {.words = unit == std::string::npos ? std::string() : column.substr(0, unit),
          .unit = Pretty(column.substr(begin, per - begin)) + "/" + denominator,
          .factor = 1};
}

/// Where the unit begins in a name that ends with `suffix` ("track_radius_m" → at "_m").
std::size_t UnitBegin(const std::string& column, std::string_view suffix) {
  if (suffix.front() == '_') return column.size() - suffix.size();
  const std::size_t word = suffix.find('_', suffix.starts_with("T_") ? 2 : 0);
  return column.size() - suffix.size() + word;
}

}  // namespace

ReadableName Readable(const std::string& of) {
  constexpr std::string_view kValue = "_value";  // of a number beside its limit
  const std::string column = of.ends_with(kValue) ? of.substr(0, of.size() - kValue.size()) : of;
  ReadableName name{.words = column, .unit = "–", .factor = 1};
  const std::size_t per = column.find("_per_");
  if (per != std::string::npos && per > 0) {
    name = Quotient(column, per);
  } else {
    for (const Unit& unit : kUnits) {
      if (!column.ends_with(unit.suffix)) continue;
      name = {.words = column.substr(0, UnitBegin(column, unit.suffix)),
              .unit = unit.shown,
              .factor = unit.factor};
      break;
    }
  }
  for (const auto& [word, words] : kWords) {
    if (name.words == word) name.words = words;
  }
  std::replace(name.words.begin(), name.words.end(), '_', ' ');
  return name;
}

}  // namespace phs::report
