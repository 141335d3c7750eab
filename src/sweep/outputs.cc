#include "sweep/outputs.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "base/words.h"

namespace phs::sweep {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> Parts(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

bool NamesList(const std::string& part) {
  return part == "wheelsets" || part == "wheels" || part == "cylinders" || part == "lines";
}

const Json* Member(const Json& node, const std::string& part, std::vector<std::string>* known) {
  if (node.is_object()) {
    for (const auto& item : node.items()) known->push_back(item.key());
    const auto found = node.find(part);
    return found == node.end() ? nullptr : &*found;
  }
  if (!node.is_array()) return nullptr;
  for (const Json& element : node) {
    if (!element.is_object() || !element.contains("name")) continue;
    known->push_back(element["name"].get<std::string>());
    if (known->back() == part) return &element;
  }
  return nullptr;
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

Result<double> FindOutput(const Json& summary, const std::string& path) {
  const Json* node = &summary;
  for (const std::string& part : Parts(path)) {
    std::vector<std::string> known;
    const Json* member = Member(*node, part, &known);
    if (member == nullptr) {
      return Error{"outputs: " + path, "the summary has no " + Quoted(part), JoinWords(known),
                   DidYouMean(part, known)};
    }
    node = member;
  }
  if (node->is_number()) return node->get<double>();
  if (node->is_null()) return std::numeric_limits<double>::quiet_NaN();
  return Error{"outputs: " + path, "is no number", "a path to a number", ""};
}

}  // namespace phs::sweep
