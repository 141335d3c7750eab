#include "identify/models/bogie_model.h"

#include <algorithm>
#include <set>

#include "base/data_path.h"
#include "identify/models/bogie_candidates.h"
#include "identify/models/own_candidates.h"
#include "phs_model/phs_model.h"
#include "vehicle/box_springs.h"
#include "vehicle/compose.h"
#include "vehicle/scenario_file.h"
#include "vehicle/simulation.h"

namespace phs::identify::search {

using measurement::FitData;
namespace {

using hydraulics::EffectParams;
using hydraulics::PhsParams;
using vehicle::Scenario;
using vehicle::Simulation;

constexpr int kCylinders = 4;  // a quarter model is spread over them

bool IsEffectOf(const PhsParams& params, const std::string& name) {
  return std::any_of(params.effects.begin(), params.effects.end(),
                     [&](const EffectParams& e) { return e.name == name; });
}

}  // namespace

std::vector<std::string> TakenApart(const PhsParams& params, const std::vector<std::string>& free) {
  const std::string every = "lines.";
  std::vector<std::string> out;
  for (const std::string& name : free) {
    std::vector<std::string> each;
    std::set<double> values;
    if (name.starts_with(every)) {
      for (const auto& line : params.lines) {
        each.push_back(line.name + "." + name.substr(every.size()));
        if (auto value = phs_model::GetParameter(params, each.back()); value.ok()) {
          values.insert(value.value());
        }
      }
    }
    if (values.size() > 1) {
      out.insert(out.end(), each.begin(), each.end());
    } else {
      out.push_back(name);
    }
  }
  return out;
}

Result<BogieModel> LoadBogieModel(const std::string& scenario, const std::vector<std::string>& free,
                                  const std::vector<std::string>& candidates) {
  auto loaded = vehicle::LoadScenario(scenario);
  if (!loaded.ok()) return loaded.error();
  BogieModel model;
  model.scenario = std::move(loaded).value();
  Scenario& s = model.scenario;
  if (s.vehicle != "bogie") {
    return Error{s.name + ": vehicle", "a locomotive has several PHS", "vehicle: bogie",
                 "identify one bogie at a time"};
  }
  if (s.phs.empty()) s.phs = vehicle::PhsModelOf(s.bogie);
  if (s.phs.empty()) return Error{s.name + ": bogie", "bogie " + s.bogie + " has no PHS", "", ""};
  auto path = FindData("PHS model", "models/phs", s.phs, {".yaml"});
  if (!path.ok()) return path.error();
  auto phs = phs_model::LoadChangedParams(path.value(), s.phs_changes, "", kCylinders);
  if (!phs.ok()) return phs.error();
  model.phs = std::move(phs).value();
  for (const EffectParams& effect : s.effects) {  // those of wheel and track: not tried again
    if (vehicle::FindRunningEffect(effect.name) != nullptr) model.phs.effects.push_back(effect);
  }
  model.free = free;
  // Oil yields a tenth of what gas does and in nearly the same way: a run that the vehicle predicts
  // does not tell it.
  if (free.empty()) model.free = {"friction.scale", "lines.gas_volume_m3"};
  model.free = TakenApart(model.phs, model.free);
  if (Status st = CheckFree(model.phs, model.free); !st.ok()) return st.error();
  if (Status st = CheckAsked(candidates, BogieCandidateNames(), "a bogie"); !st.ok()) {
    return st.error();
  }
  model.candidates = candidates;
  Scenario instant = s;
  instant.duration_s = 1e-6;  // one step
  auto simulation = Simulation::Create(instant);
  if (!simulation.ok()) return simulation.error();
  s.timestep_s = simulation.value().scenario().timestep_s;
  auto run = simulation.value().Run();
  if (!run.ok()) return run.error();
  for (const auto& channel : run.value().channels) {
    model.observed.push_back(channel.name), model.unit.push_back(channel.unit);
  }
  model.start_m = run.value().columns[static_cast<size_t>(run.value().Find("s_m"))].front();
  model.declared.friction = simulation.value().binding().friction();
  model.declared.boxes = vehicle::BoxNames(simulation.value().model());
  model.track_length_m = simulation.value().binding().track().length();
  return model;
}

void FreeByWays(BogieModel* model) {
  for (std::string& name : TakenApart(model->phs, {"lines.oil_volume_m3"})) {
    model->free.push_back(std::move(name));
  }
  if (model->phs.friction.model == hydraulics::FrictionModel::kPresliding) {
    model->free.emplace_back("friction.stiffness_N_per_m");
  }
}

Result<Scenario> ScenarioWith(const BogieModel& model, const PhsParams& params) {
  Scenario s = model.scenario;
  for (const std::string& name : model.free) {
    auto value = phs_model::GetParameter(params, name);
    if (!value.ok()) return value.error();
    s.phs_changes.parameters[name] = value.value();
  }
  for (const EffectParams& effect : params.effects) {
    if (IsEffectOf(model.phs, effect.name)) continue;
    if (Status st = vehicle::AddEffect(effect, &s); !st.ok()) return st.error();
  }
  return s;
}

std::string RunChannelOf(const BogieModel& model, const std::string& column) {
  const auto known = [&](const std::string& name) {
    return std::find(model.observed.begin(), model.observed.end(), name) != model.observed.end();
  };
  if (known(column)) return column;
  const auto between = [&](const std::string& begin, const std::string& end) -> std::string {
    if (!column.starts_with(begin) || !column.ends_with(end)) return "";
    if (column.size() <= begin.size() + end.size()) return "";
    return column.substr(begin.size(), column.size() - begin.size() - end.size());
  };
  std::string name;
  if (const std::string id = between("piston", "_m"); !id.empty()) {
    name = "cylinder_" + id + "_piston_m";
  } else if (const std::string of = between("load", "_N"); !of.empty()) {
    name = "cylinder_" + of + "_force_N";
  } else if (const std::string line = between("p", "_Pa"); !line.empty()) {
    name = "line_" + line + "_pressure_Pa";
  }
  return known(name) ? name : "";
}

PhsOutputsOf FindPhsOutputs(const BogieModel& model, const FitData& data) {
  const auto find = [&](const std::string& channel) {
    for (size_t i = 0; i < data.outputs.size(); ++i) {
      if (RunChannelOf(model, data.outputs[i].name) == channel) return static_cast<int>(i);
    }
    return -1;
  };
  PhsOutputsOf out;
  for (const auto& cylinder : model.phs.cylinders) {
    out.pistons.push_back(find("cylinder_" + cylinder.name + "_piston_m"));
    out.forces.push_back(find("cylinder_" + cylinder.name + "_force_N"));
  }
  for (const auto& line : model.phs.lines) {
    out.pressures.push_back(find("line_" + line.name + "_pressure_Pa"));
  }
  return out;
}

}  // namespace phs::identify::search
