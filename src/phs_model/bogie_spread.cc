#include "phs_model/bogie_spread.h"

#include <algorithm>

#include "base/check.h"
#include "effects/catalogue.h"
#include "effects/own_law.h"

namespace phs::phs_model {

using hydraulics::CylinderParams;
using hydraulics::EffectParams;
using hydraulics::LineParams;
using hydraulics::PhsParams;

bool IsQuarter(const PhsParams& params) {
  return params.cylinders.size() == 1 && params.lines.size() == 2 &&
         !params.cylinders[0].bore_line.empty() && !params.cylinders[0].rod_line.empty() &&
         params.cylinders[0].bore_line != params.cylinders[0].rod_line;
}

PhsParams SpreadOverBogie(const PhsParams& quarter) {
  PHS_CHECK(IsQuarter(quarter));
  const CylinderParams& one = quarter.cylinders[0];
  const LineParams& rod = quarter.lines[static_cast<size_t>(quarter.FindLine(one.rod_line))];
  const LineParams& bore = quarter.lines[static_cast<size_t>(quarter.FindLine(one.bore_line))];
  PhsParams bogie = quarter;
  // The levels stay; how they are reached is for a run in time to stand: static friction is too
  // steep at zero speed for any sensible step.
  if (bogie.friction.model == hydraulics::FrictionModel::kStatic) {
    bogie.friction.model = hydraulics::FrictionModel::kPresliding;
  }
  bogie.cylinders.clear(), bogie.lines.clear(), bogie.effects.clear();
  const char* const lines[][3] = {
      {"1", "L2", "L1"}, {"2", "L3", "L1"}, {"3", "L2", "L4"}, {"4", "L3", "L4"}};
  for (const auto& [name, bore_line, rod_line] : lines) {
    CylinderParams cylinder = one;
    cylinder.name = name, cylinder.bore_line = bore_line, cylinder.rod_line = rod_line;
    bogie.cylinders.push_back(cylinder);
  }
  for (const char* name : {"L1", "L2", "L3", "L4"}) {
    const bool cross = std::string(name) == "L1" || std::string(name) == "L4";
    bogie.lines.push_back(cross ? rod : bore);
    bogie.lines.back().name = name;
  }
  for (EffectParams effect : quarter.effects) {
    const auto* info = effects::Catalogue().FindFor(effect);
    if (effects::StaysOnRig(effect)) continue;
    if (info != nullptr && (info->family == "instrument" || info->family == "element")) continue;
    std::vector<std::string> targets;
    for (const std::string& target : effect.targets) {
      if (target == rod.name) targets.insert(targets.end(), {"L1", "L4"});
      if (target == bore.name) targets.insert(targets.end(), {"L2", "L3"});
      if (target == one.name) targets.insert(targets.end(), {"1", "2", "3", "4"});
    }
    effect.targets = targets;
    bogie.effects.push_back(effect);
  }
  return bogie;
}

}  // namespace phs::phs_model
