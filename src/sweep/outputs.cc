#include "sweep/outputs.h"

#include <sstream>

namespace phs::sweep {
namespace {

std::vector<std::string> Parts(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

bool NamesList(const std::string& part) {
  return part == "wheelsets" || part == "wheels" || part == "cylinders" || part == "lines";
}

}  // namespace

std::vector<std::string> DefaultOutputs() {
  return {"steady_curve.wheelsets.lead.angle_of_attack_rad",
          "steady_curve.wheelsets.trail.angle_of_attack_rad",
          "steady_curve.wheelsets.lead.lateral_m",
          "steady_curve.wheels.lead_outer.Y_N",
          "steady_curve.wheels.lead_outer.Y_over_Q",
          "steady_curve.wheels.lead_outer.T_gamma_N",
          "run.T_gamma_total_J",
          "run.max_Y_over_Q",
          "run.max_sum_Y_N",
          "run.max_angle_of_attack_rad",
          "run.energy_error_relative"};
}

std::string OutputColumn(const std::string& path) {
  std::string column;
  const auto parts = Parts(path);
  for (std::size_t i = parts.size() > 1 ? 1 : 0; i < parts.size(); ++i) {
    if (NamesList(parts[i])) continue;
    column += (column.empty() ? "" : "_") + parts[i];
  }
  return column;
}

}  // namespace phs::sweep
