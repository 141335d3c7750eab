#include "identify/select/passivity.h"

#include <fmt/format.h>

#include <cmath>

#include "effects/catalogue.h"
#include "effects/formula.h"
#include "effects/unlisted.h"
#include "hydraulics/phs_system.h"

namespace phs::identify::search {
namespace {

using effects::Formula;
using effects::FormulaUnit;
using hydraulics::ForcePlace;

/// The law with its fitted coefficients, if they have this unit.
Result<Formula> LawOf(const hydraulics::EffectParams& effect, FormulaUnit unit) {
  std::map<std::string, double> coefficients;
  const std::string ending = std::string("_") + effects::UnitSuffix(unit);
  for (const auto& [name, value] : effect.values) {
    const size_t end = name.find('_');
    if (name.substr(end) == ending) coefficients[name.substr(0, end)] = value;
  }
  return Formula::Parse(effect.formula, coefficients, unit);
}

/// Work taken in, and by its size [J], in retraction and extension.
struct Work {
  double taken[2] = {0, 0};
};

Work FrictionWork(const Formula& law, const hydraulics::Friction& friction,
                  const std::vector<std::vector<ForcePlace>>& records) {
  Work work;
  for (const std::vector<ForcePlace>& record : records) {
    for (size_t i = 0; i + 1 < record.size(); ++i) {
      const ForcePlace& at = record[i];
      ForcePlace still = at;
      still.speed = still.direction = 0;
      const int side = at.speed > 0 ? 1 : 0;
      const double sign = side == 1 ? 1 : -1;
      hydraulics::FrictionPlace place;
      place.bore_rise = at.bore_rise, place.rod_rise = at.rod_rise, place.piston = at.piston;
      place.time = at.time, place.warmer = at.temperature;
      const double level = friction.Level(side == 1 ? 1 : -1, std::abs(at.speed), place);
      const double force = level + sign * (law.Value(at) - law.Value(still));
      work.taken[side] += force * std::abs(at.speed) * (record[i + 1].time - at.time);
    }
  }
  return work;
}

std::string ForceThatDrives(const FitProblem& problem, const Identification& found,
                            const hydraulics::PhsParams& params, const Formula& law) {
  if (params.cylinders.size() > 1) return {};
  const char* channel = problem.FindOutput("force_N") >= 0 ? "force_N" : "load_cell_N";
  const auto system = hydraulics::PhsSystem::Create(params, &effects::Catalogue());
  const auto frame = problem.forward().Frame(params, channel);
  if (!system.ok() || !frame.ok()) return {};
  const Work work = FrictionWork(law, system.value().friction(0), frame.value().places);
  for (const int side : {1, 0}) {
    if (work.taken[side] >= 0) continue;
    return fmt::format(
        "the formula {} drives: with it the friction gives out {:.3g} J in {} over the record",
        found.formula.text, -work.taken[side], side == 1 ? "extension" : "retraction");
  }
  return {};
}

/// Over the pressures that the record's own channels show about the static ones.
std::string FlowThatDrives(const FitProblem& problem, const Identification& found,
                           const hydraulics::PhsParams& params, const Formula& law) {
  if (params.cylinders.size() != 1) return {};
  const auto& cylinder = params.cylinders.front();
  const auto frame = problem.forward().Frame(params, "load_cell_N");
  if (!frame.ok()) return {};
  const std::vector<std::string>& on = found.formula.targets;
  const auto is_on = [&](const std::string& line) {
    return on.empty() || std::find(on.begin(), on.end(), line) != on.end();
  };
  const bool past = std::find(on.begin(), on.end(), cylinder.name) != on.end();
  double work = 0;
  for (const auto& record : frame.value().places) {
    for (size_t i = 0; i + 1 < record.size(); ++i) {
      const double step = record[i + 1].time - record[i].time;
      const auto add = [&](double p) {
        ForcePlace at = record[i], still = at;
        at.bore_rise = p, still.bore_rise = 0;
        work += (law.Value(at) - law.Value(still)) * p * step;
      };
      if (past) add(record[i].bore_rise - record[i].rod_rise);
      if (!past && is_on(cylinder.bore_line)) add(record[i].bore_rise);
      if (!past && is_on(cylinder.rod_line)) add(record[i].rod_rise);
    }
  }
  if (work >= 0) return {};
  return fmt::format("the flow {} drives: it gives out {:.3g} J over the record",
                     found.formula.text, -work);
}

}  // namespace

std::vector<std::string> WhatDrives(const FitProblem& problem, const Identification& found) {
  if (found.formula.empty()) return {};
  const hydraulics::PhsParams params = ParamsOf(found.corrected, found.after.values);
  std::vector<std::string> out;
  for (const hydraulics::EffectParams& effect : params.effects) {
    if (effect.name != effects::UnlistedInfo().name || effect.formula != found.formula.text) {
      continue;
    }
    const bool flow = found.formula.unit == "m3_per_s";
    if (!flow && found.formula.unit != "N") continue;
    const Result<Formula> law = LawOf(effect, flow ? FormulaUnit::kFlow : FormulaUnit::kForce);
    if (!law.ok() || law.value().Uses("F")) continue;  // over F: what the load cell shows
    const std::string text = flow ? FlowThatDrives(problem, found, params, law.value())
                                  : ForceThatDrives(problem, found, params, law.value());
    if (!text.empty()) out.push_back(text);
  }
  return out;
}

}  // namespace phs::identify::search
