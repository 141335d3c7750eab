#include "rail/creep_conditions.h"

namespace phs::rail {

const std::vector<FrictionCondition>& FrictionConditions() {
  static const char kPolach[] = "Polach, Wear 258 (2005) 992, table of parameters";
  static const char kEurosprinter[] =
      "Polach 2005, Siemens Eurosprinter test; fits: CONTACT user guide, creep-force curves";
  static const SlopeReduction kTheory;
  static const std::vector<FrictionCondition> conditions = {
      {"dry", {0.3, 1, 0}, {0.3, 1, 0}, 1, 1, kTheory, "usual value for dry rails"},
      {"wet", {0.15, 1, 0}, {0.15, 1, 0}, 1, 1, kTheory, "usual value for wet rails"},
      {"flange_lubricated",
       {0.3, 1, 0},
       {0.1, 1, 0},
       1,
       1,
       kTheory,
       "usual values with flange lubrication"},
      {"dry_traction", {0.55, 0.40, 0.60}, {0.55, 0.40, 0.60}, 1.0, 0.40, kTheory, kPolach},
      {"wet_traction", {0.30, 0.40, 0.20}, {0.30, 0.40, 0.20}, 0.30, 0.10, kTheory, kPolach},
      {"eurosprinter",
       {0.36, 0.38, 0.70},
       {0.36, 0.38, 0.70},
       1,
       1,
       {0.54, 0.02, 0.62},
       kEurosprinter},
  };
  return conditions;
}

std::vector<std::string> FrictionConditionNames() {
  std::vector<std::string> names;
  for (const FrictionCondition& c : FrictionConditions()) names.push_back(c.name);
  return names;
}

Result<FrictionCondition> FindFrictionCondition(const std::string& name) {
  std::string known;
  for (const FrictionCondition& c : FrictionConditions()) {
    if (c.name == name) return c;
    known += (known.empty() ? "" : ", ") + c.name;
  }
  return Error{"friction condition", "'" + name + "' is not known", known, ""};
}

void ApplyCondition(const FrictionCondition& condition, CreepLawParams* params) {
  params->polach_adhesion = condition.polach_adhesion;
  params->polach_slip = condition.polach_slip;
  params->slope_reduction = condition.slope_reduction;
}

}  // namespace phs::rail
