#include "vehicle/running_effects.h"

#include <fmt/format.h>

#include "base/words.h"
#include "effects/catalogue.h"
#include "phs_model/phs_model.h"

namespace phs::vehicle {

namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParameter;
using hydraulics::EffectParams;
using hydraulics::Walk;
using Values = std::map<std::string, double>;

std::vector<RunningEffect> MakeTable() {
  std::vector<RunningEffect> rows;
  rows.push_back({EffectInfo{"tread_wear",
                             "wheel",
                             "",
                             "z - d/2 (1 + cos(pi (y - y0)/w)): hollow tread of all wheels",
                             {{"depth_m", "m", 0, -0.005, 0.005, -1e-3, 3e-3, "d"},
                              {"half_width_m", "m", 0.03, 0.01, 0.06, 0.02, 0.05, "w"},
                              {"centre_m", "m", 0, -0.03, 0.03, -0.02, 0.02, "y0"}},
                             nullptr,
                             {.bogie = {{.free = {{"depth_m", 2e-4, 1e-3, 4}}}}}},
                  [](const Values& v, Scenario* s) {
                    s->wear = {v.at("depth_m"), v.at("half_width_m"), v.at("centre_m")};
                  }});
  rows.push_back(
      {EffectInfo{"wheel_rail_friction",
                  "wheel",
                  "",
                  "friction coefficient of wheel on rail other than declared",
                  {{"coefficient", "1", 0.3, 0.01, 1, 0.03, 0.65, "of the tread at rest"}},
                  nullptr,
                  {.bogie = {{.free = {{"coefficient", 0.3, 0.3, 1, Walk::kEitherWay}}}}}},
       [](const Values& v, Scenario* s) { s->friction.tread = v.at("coefficient"); },
       [](const DeclaredRunning& declared) { return declared.friction; }});
  rows.push_back(
      {EffectInfo{"cant_error",
                  "track",
                  "",
                  "superelevation of curves other than declared, transitions in proportion",
                  {{"cant_m", "m", 0, -0.1, 0.1, -0.06, 0.06, "> 0 raises the outer rail"}},
                  nullptr,
                  {.bogie = {{.free = {{"cant_m", 0}}}}}},
       [](const Values& v, Scenario* s) { s->track_errors.cant_m = v.at("cant_m"); }});
  rows.push_back(
      {EffectInfo{"gauge_error",
                  "track",
                  "",
                  "gauge other than declared, everywhere",
                  {{"widening_m", "m", 0, -0.02, 0.05, -0.01, 0.02, "> 0 wider"}},
                  nullptr,
                  {.bogie = {{.free = {{"widening_m", 0}}}}}},
       [](const Values& v, Scenario* s) { s->track_errors.widening_m = v.at("widening_m"); }});
  return rows;
}

std::vector<std::string> KnownNames() {
  std::vector<std::string> names;
  for (const RunningEffect& row : RunningEffects()) names.push_back(row.info.name);
  for (const EffectInfo& info : effects::Catalogue().effects()) names.push_back(info.name);
  return names;
}

Status CheckValues(const EffectInfo& info, const EffectParams& effect, Values* values) {
  const std::string where = "effects." + effect.name;
  if (!effect.targets.empty() || !effect.formula.empty()) {
    return Error{where, "has no targets and no formula", "numbers only", ""};
  }
  std::vector<std::string> keys;
  for (const EffectParameter& p : info.parameters) {
    (*values)[p.name] = p.otherwise, keys.push_back(p.name);
  }
  for (const auto& [key, value] : effect.values) {
    if (!values->contains(key)) {
      return Error{where + "." + key, "unknown key", JoinWords(keys), DidYouMean(key, keys)};
    }
    (*values)[key] = value;
  }
  for (const EffectParameter& p : info.parameters) {
    const double value = values->at(p.name);
    if (value >= p.min && value <= p.max) continue;
    return Error{where + "." + p.name, fmt::format("{:g} is out of range", value),
                 fmt::format("{:g} to {:g} {}", p.min, p.max, p.unit), ""};
  }
  return {};
}

}  // namespace

const std::vector<RunningEffect>& RunningEffects() {
  static const std::vector<RunningEffect> table = MakeTable();
  return table;
}

const RunningEffect* FindRunningEffect(const std::string& name) {
  for (const RunningEffect& row : RunningEffects()) {
    if (row.info.name == name) return &row;
  }
  return nullptr;
}

Status AddEffect(const EffectParams& effect, Scenario* scenario) {
  for (const EffectParams& present : scenario->effects) {
    if (present.name != effect.name) continue;
    return Error{"effects." + effect.name, "is given twice", "each effect once", ""};
  }
  if (const RunningEffect* row = FindRunningEffect(effect.name)) {
    Values values;
    if (Status s = CheckValues(row->info, effect, &values); !s.ok()) return s;
    row->apply(values, scenario);
  } else if (effects::Catalogue().FindFor(effect) != nullptr) {
    scenario->phs_changes.effects.push_back(effect);  // its keys are checked with the PHS model
  } else {
    const std::vector<std::string> names = KnownNames();
    return Error{"effects." + effect.name, "no such effect", JoinWords(names),
                 DidYouMean(effect.name, names)};
  }
  scenario->effects.push_back(effect);
  return {};
}

}  // namespace phs::vehicle
