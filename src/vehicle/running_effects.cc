#include "vehicle/running_effects.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/words.h"
#include "effects/catalogue.h"
#include "phs_model/phs_model.h"

namespace phs::vehicle {

namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParameter;
using hydraulics::EffectParams;
using hydraulics::Places;
using hydraulics::Walk;

RunningEffect BoxSpring() {
  return {EffectInfo{"box_spring",
                     "suspension",
                     "boxes",
                     "k f: springs of these axle boxes other than the rest",
                     {{"factor", "-", 1, 0.02, 50, 0.1, 5, "f", true}},
                     nullptr,
                     {.bogie = {{.free = {{"factor", 0.3, 0.7, 2, Walk::kEitherWay}},
                                 .places = Places::kAlone}}}},
          [](const EffectParams& e, Scenario* s) {
            const double factor = e.values.at("factor");
            for (const std::string& box : e.targets) s->box_springs.push_back({box, factor});
            if (e.targets.empty()) s->box_springs.push_back({"", factor});
          },
          [](const DeclaredRunning&) { return 1.0; }};
}

std::vector<RunningEffect> MakeTable() {
  std::vector<RunningEffect> rows;
  rows.push_back(
      {EffectInfo{"tread_wear",
                  "wheel",
                  "",
                  "z - d/2 (1 + cos(pi (y - y0)/w)): hollow tread of all wheels",
                  {{"depth_m", "m", 0, -0.005, 0.005, -1e-3, 3e-3, "d"},
                   {"half_width_m", "m", 0.03, 0.01, 0.06, 0.02, 0.05, "w"},
                   {"centre_m", "m", 0, -0.03, 0.03, -0.02, 0.02, "y0"}},
                  nullptr,
                  {.bogie = {{.free = {{"depth_m", 2e-4, 1e-3, 4}}}}}},
       [](const EffectParams& e, Scenario* s) {
         s->wear = {e.values.at("depth_m"), e.values.at("half_width_m"), e.values.at("centre_m")};
       }});
  rows.push_back(
      {EffectInfo{"wheel_rail_friction",
                  "wheel",
                  "",
                  "friction coefficient of wheel on rail other than declared",
                  {{"coefficient", "1", 0.3, 0.01, 1, 0.03, 0.65, "of the tread at rest"}},
                  nullptr,
                  {.bogie = {{.free = {{"coefficient", 0.3, 0.3, 1, Walk::kEitherWay}}}}}},
       [](const EffectParams& e, Scenario* s) { s->friction.tread = e.values.at("coefficient"); },
       [](const DeclaredRunning& declared) { return declared.friction; }});
  rows.push_back(
      {EffectInfo{"cant_error",
                  "track",
                  "",
                  "superelevation of curves other than declared, transitions in proportion",
                  {{"cant_m", "m", 0, -0.1, 0.1, -0.06, 0.06, "> 0 raises the outer rail"}},
                  nullptr,
                  {.bogie = {{.free = {{"cant_m", 0.01, 0.01, 1, Walk::kEitherWay}}}}}},
       [](const EffectParams& e, Scenario* s) { s->track_errors.cant_m = e.values.at("cant_m"); }});
  rows.push_back(
      {EffectInfo{"gauge_error",
                  "track",
                  "",
                  "gauge other than declared, everywhere",
                  {{"widening_m", "m", 0, -0.02, 0.05, -0.01, 0.02, "> 0 wider"}},
                  nullptr,
                  {.bogie = {{.free = {{"widening_m", 0.003, 0.003, 1, Walk::kEitherWay}}}}}},
       [](const EffectParams& e, Scenario* s) {
         s->track_errors.widening_m = e.values.at("widening_m");
       }});
  rows.push_back(BoxSpring());
  return rows;
}

std::vector<std::string> KnownNames() {
  std::vector<std::string> names;
  for (const RunningEffect& row : RunningEffects()) names.push_back(row.info.name);
  for (const EffectInfo& info : effects::Catalogue().effects()) names.push_back(info.name);
  return names;
}

/// Checks what a scenario says and fills in what it does not.
Status Complete(const EffectInfo& info, EffectParams* effect) {
  const std::string where = "effects." + effect->name;
  if (!effect->formula.empty() || (info.targets.empty() && !effect->targets.empty())) {
    return Error{where, "has no targets and no formula", "numbers only", ""};
  }
  std::vector<std::string> keys;
  for (const EffectParameter& p : info.parameters) keys.push_back(p.name);
  for (const auto& [key, value] : effect->values) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    return Error{where + "." + key, "unknown key", JoinWords(keys), DidYouMean(key, keys)};
  }
  for (const EffectParameter& p : info.parameters) {
    const double value = effect->values.emplace(p.name, p.otherwise).first->second;
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
    EffectParams complete = effect;
    if (Status s = Complete(row->info, &complete); !s.ok()) return s;
    row->apply(complete, scenario);
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
