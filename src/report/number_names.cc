#include "report/number_names.h"

#include <string_view>
#include <vector>

#include "report/readable_name.h"

namespace phs::report {
namespace {

struct Quantity {
  const char* list;  ///< part of the path before the item, or before the key
  const char* key;
  const char* words;
  const char* unit;
  double factor;
};

constexpr Quantity kQuantities[] = {
    {"wheelsets", "lateral_m", "Lateral position", "mm", 1e3},
    {"wheelsets", "angle_of_attack_rad", "Angle of attack", "mrad", 1e3},
    {"wheelsets", "yaw_rad", "Yaw in the bogie", "mrad", 1e3},
    {"wheelsets", "sum_Y_N", "Track-shifting force ΣY", "kN", 1e-3},
    {"wheels", "Y_N", "Guiding force Y", "kN", 1e-3},
    {"wheels", "Q_N", "Wheel load Q", "kN", 1e-3},
    {"wheels", "Y_over_Q", "Y/Q", "–", 1},
    {"wheels", "T_gamma_N", "Wear number Tγ", "N", 1},
    {"wheels", "T_gamma_spin_N", "Spin part of the wear number |Mz φ|", "N", 1},
    {"cylinders", "force_N", "Cylinder force", "kN", 1e-3},
    {"cylinders", "friction_N", "Seal friction", "kN", 1e-3},
    {"cylinders", "piston_m", "Piston displacement", "mm", 1e3},
    {"lines", "pressure_Pa", "Line pressure", "MPa", 1e-6},
    {"steady_curve", "bending_rad", "Bending (steering) of the bogie", "mrad", 1e3},
    {"steady_curve", "shear_rad", "Shear of the bogie", "mrad", 1e3},
    {"steady_curve", "T_gamma_N", "Wear number Tγ, all wheels", "N", 1},
    {"run", "T_gamma_total_J", "Work lost as Tγ along the track", "kJ", 1e-3},
    {"run", "max_Y_over_Q", "Greatest Y/Q", "–", 1},
    {"run", "max_sum_Y_N", "Greatest ΣY", "kN", 1e-3},
    {"run", "max_angle_of_attack_rad", "Greatest angle of attack", "mrad", 1e3},
    {"run", "min_Q_N", "Smallest wheel load Q", "kN", 1e-3},
    {"run", "lost_creep_J", "Lost in creep between wheel and rail", "kJ", 1e-3},
    {"run", "lost_phs_J", "Lost in the hydraulic steering", "kJ", 1e-3},
    {"budget", "creep_Nm", "Yaw moment of the creep forces", "kN m", 1e-3},
    {"budget", "phs_pressure_Nm", "Yaw moment of the oil pressure", "kN m", 1e-3},
    {"budget", "phs_friction_Nm", "Yaw moment of the seal friction", "kN m", 1e-3},
    {"budget", "primary_Nm", "Yaw moment of the primary suspension with its links", "kN m", 1e-3}};

std::vector<std::string> Split(const std::string& path) {
  std::vector<std::string> parts = {""};
  for (const char c : path) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// "front bogie" and what is left of the name behind its prefix.
std::string TakeBogie(std::string* name) {
  for (const std::string_view bogie : {"front", "rear"}) {
    if (!name->starts_with(std::string(bogie) + "_")) continue;
    name->erase(0, bogie.size() + 1);
    return std::string(bogie) + " bogie";
  }
  return "";
}

std::string ItemWords(const std::string& list, const std::string& item) {
  if (list == "wheelsets" || list == "budget") return PlaceWords(item, "axle");
  if (list == "wheels") return PlaceWords(item, "wheel");
  if (list == "cylinders") return "cylinder " + item;
  return "line " + item;
}

}  // namespace

std::string PlaceWords(const std::string& name, const std::string& noun) {
  std::string rest = name;
  const std::string bogie = TakeBogie(&rest);
  const size_t end = rest.find('_');
  const std::string axle = rest.substr(0, end);
  const std::string word = axle == "lead" ? "leading" : axle == "mid" ? "middle" : "trailing";
  if (word == "trailing" && axle != "trail") return name;
  const std::string side = end == std::string::npos ? "" : " " + rest.substr(end + 1);
  return (bogie.empty() ? "" : bogie + ", ") + word + side + " " + noun;
}

NumberName NameOfNumber(const std::string& path) {
  const std::vector<std::string> parts = Split(path);
  if (parts.size() >= 2) {
    const bool listed = parts.size() >= 3;
    // steady_curve.LIST.ITEM.KEY, budget.ITEM.KEY; steady_curve.KEY, run.KEY
    const std::string list = listed ? parts[parts.size() - 3] : parts[0];
    std::string key = parts.back();
    const std::string bogie = listed ? "" : TakeBogie(&key);
    for (const Quantity& q : kQuantities) {
      if (list != q.list || key != q.key) continue;
      std::string words = q.words;
      if (listed) words += ", " + ItemWords(list, parts[parts.size() - 2]);
      if (!bogie.empty()) words += ", " + bogie;
      return {words, q.unit, q.factor};
    }
  }
  const ReadableName plain = Readable(parts.back());
  return {plain.words, plain.unit, plain.factor};
}

}  // namespace phs::report
