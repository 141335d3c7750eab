#include "rail/creep_conditions.h"

#include "base/words.h"

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
  return Error{"friction condition", "'" + name + "' is not known", known,
               DidYouMean(name, FrictionConditionNames())};
}

Status ApplyFriction(const FrictionSettings& settings, WheelRailParams* params) {
  if (!settings.condition.empty()) {
    const auto condition = FindFrictionCondition(settings.condition);
    if (!condition.ok()) return condition.error();
    params->tread = condition.value().tread;
    params->flange = condition.value().flange;
    params->creep.polach_adhesion = condition.value().polach_adhesion;
    params->creep.polach_slip = condition.value().polach_slip;
    params->creep.slope_reduction = condition.value().slope_reduction;
  }
  if (settings.tread >= 0) {
    params->tread.coefficient = settings.tread;
    if (settings.condition.empty()) params->flange.coefficient = settings.tread;
  }
  if (settings.flange >= 0) params->flange.coefficient = settings.flange;
  for (FrictionLaw* law : {&params->tread, &params->flange}) {
    if (settings.falling_ratio >= 0) law->falling_ratio = settings.falling_ratio;
    if (settings.falling_rate_s_m >= 0) law->falling_rate_s_m = settings.falling_rate_s_m;
  }
  return {};
}

}  // namespace phs::rail
