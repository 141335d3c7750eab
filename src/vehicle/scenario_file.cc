#include "vehicle/scenario_file.h"

#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "base/data_path.h"
#include "base/yaml.h"
#include "phs_model/effects_yaml.h"
#include "phs_model/model_changes.h"
#include "phs_model/phs_model.h"
#include "rail/creep_law.h"
#include "vehicle/running_effects.h"

namespace phs::vehicle {

namespace {

/// `running:` torque and block forces on the axles; the train holds the speed.
void ReadRunning(YamlMap map, Scenario* s) {
  plugin::RunningForces& r = s->running;
  r.active = true;
  r.drive_torque_Nm = map.Number("drive_torque_Nm", {.min = -1e6, .max = 1e6}, 0.0);
  r.block_force_N = map.Number("block_force_N", {.min = 0, .max = 1e6}, 0.0);
  r.block_friction =
      map.Number("block_friction", {.min = 0, .max = 1, .open_min = true}, r.block_friction);
  r.begin_s = map.Number("begin_s", {.min = 0, .max = 1e6}, r.begin_s);
  r.ramp_s = map.Number("ramp_s", {.min = 0, .max = 1e6, .open_min = true}, r.ramp_s);
  r.end_s = map.Number("end_s", {.min = 0, .max = 1e6}, r.end_s);
  if (r.end_s > 0 && r.end_s < r.begin_s + r.ramp_s) {
    map.Fail("end_s", "lies before the moments are there",
             "0 (to the end of the run), or begin_s + ramp_s and later");
  }
}

/// `friction:` a coefficient, or a block with a condition by name and single values of its own.
void ReadFriction(YamlMap* map, rail::FrictionSettings* f) {
  const Range coefficients{.min = 0.01, .max = 1.0};
  if (!map->IsMap("friction")) {
    f->tread = map->Number("friction", coefficients, f->tread);
    f->flange = map->Number("flange_friction", coefficients, f->flange);
    return;
  }
  if (map->Has("flange_friction")) {
    map->Fail("flange_friction", "stands beside a friction block", "flange in that block");
  }
  YamlMap block = map->Map("friction");
  if (block.Has("condition")) {
    f->condition = block.Word("condition", rail::FrictionConditionNames());
  }
  f->tread = block.Number("tread", coefficients, f->tread);
  f->flange = block.Number("flange", coefficients, f->flange);
  f->falling_ratio =
      block.Number("falling_ratio", {.min = 0, .max = 1, .open_min = true}, f->falling_ratio);
  f->falling_rate_s_m =
      block.Number("falling_rate_s_m", {.min = 0, .max = 100}, f->falling_rate_s_m);
}

/// `joints:` springs and dampers by joint name.
void ReadJoints(YamlMap map, Scenario* s) {
  for (const std::string& joint : map.Keys()) {
    YamlMap entry = map.Map(joint);
    Scenario::JointChange change;
    change.joint = joint;
    change.stiffness = entry.Number("stiffness", {.min = 0, .max = 1e12}, change.stiffness);
    change.damping = entry.Number("damping", {.min = 0, .max = 1e9}, change.damping);
    s->joints.push_back(std::move(change));
  }
}

/// `naming`: the file whose folder paths begin in; empty: the current folder.
Result<Scenario> ReadScenario(YamlMap map, const std::string& naming) {
  Scenario s;
  s.name = std::filesystem::path(naming).stem().string();
  const auto beside = [&](const std::string& name) {
    return naming.empty() ? name : BesideFile(naming, name);
  };
  const auto file = [&](const char* key, const std::string& otherwise) {
    return beside(map.Text(key, otherwise));
  };
  s.track = beside(map.Text("track"));
  s.bogie = file("bogie", s.bogie);
  s.vehicle = map.Word("vehicle", {"bogie", "locomotive"}, s.vehicle);
  s.wheel = file("wheel", s.wheel);
  s.rail = file("rail", s.rail);
  s.creep = map.Text("creep", s.creep);
  rail::CreepLawParams law;
  if (Status e = rail::ChooseCreepLaw(s.creep.empty() ? law.method : s.creep, &law); !e.ok()) {
    map.Fail("creep", e.error().what, e.error().allowed, e.error().mend);
  }
  s.contact_fineness = map.Integer("contact_fineness", 1, 4, s.contact_fineness);
  s.phs = file("phs", s.phs);
  if (map.Has("speed_m_s")) {
    s.speed_m_s = map.Number("speed_m_s", {.min = 1, .max = 120});
    if (map.Has("speed_km_h")) map.Fail("speed_km_h", "repeats speed_m_s", "one of the two");
  } else {
    s.speed_m_s = map.Number("speed_km_h", {.min = 3.6, .max = 432}) / 3.6;
  }
  ReadFriction(&map, &s.friction);
  s.timestep_s = map.Number("timestep_s", {.min = 1e-6, .max = 0.05}, s.timestep_s);
  s.duration_s = map.Number("duration_s", {.min = 0, .max = 1e5, .open_min = true}, s.duration_s);
  s.start_s_m = map.Number("start_s_m", {.min = -1e4, .max = 1e7}, s.start_s_m);
  s.record_interval_s =
      map.Number("record_interval_s", {.min = 1e-6, .max = 60}, s.record_interval_s);
  if (map.Has("running")) ReadRunning(map.Map("running"), &s);
  s.phs_changes.failures = phs_model::ReadFailures(&map, s.speed_m_s, s.start_s_m);
  if (map.Has("phs_parameters"))
    phs_model::ReadParameters(map.Map("phs_parameters"), &s.phs_changes);
  if (map.Has("effects")) {
    for (const auto& effect : phs_model::ReadEffects(map.Map("effects"))) {
      if (Status added = AddEffect(effect, &s); !added.ok()) {
        const Error& e = added.error();
        map.Fail("effects", e.where + ": " + e.what, e.allowed, e.mend);
      }
    }
  }
  if (map.Has("joints")) ReadJoints(map.Map("joints"), &s);
  if (Status status = map.Finish(); !status.ok()) return status.error();
  return s;
}

/// The keys of `changes` over those of `base`; a speed in one unit replaces that in the other.
YAML::Node Merged(YAML::Node base, const YAML::Node& changes) {
  for (const auto& entry : changes) {
    const auto key = entry.first.as<std::string>();
    if (key == "speed_m_s") base.remove("speed_km_h");
    if (key == "speed_km_h") base.remove("speed_m_s");
    const bool name = entry.second.IsScalar();
    base[key] = name ? YAML::Node(Anywhere(entry.second.Scalar())) : entry.second;
  }
  return base;
}

/// What is wrong is told by its key alone.
Result<Scenario> ReadMerged(const YAML::Node& node, const std::string& naming) {
  YAML::Emitter out;
  out << YAML::Flow << node;
  auto doc = YamlMap::Parse(out.c_str(), "scenario");
  if (!doc.ok()) return doc.error();
  auto read = ReadScenario(doc.value(), naming);
  if (read.ok()) return read;
  Error error = read.error();
  const std::string name = "scenario";
  if (error.where.starts_with(name + ":")) {
    error.where.replace(0, error.where.find(": "), name);  // no line of any file of the user
  }
  return error;
}

}  // namespace

Result<Scenario> LoadScenario(const std::string& name_or_path) {
  auto path = FindData("scenario", "models/scenarios", name_or_path, {".yaml"});
  if (!path.ok()) return path.error();
  auto doc = YamlMap::Load(path.value());
  if (!doc.ok()) return doc.error();
  return ReadScenario(doc.value(), path.value());
}

Result<Scenario> ScenarioWith(const std::string& name_or_path, const std::string& changes) {
  std::string naming;
  YAML::Node base(YAML::NodeType::Map);
  if (!name_or_path.empty()) {
    if (auto whole = LoadScenario(name_or_path); !whole.ok()) return whole;
    naming = FindData("scenario", "models/scenarios", name_or_path, {".yaml"}).value();
    base = YAML::LoadFile(naming);
  }
  auto doc = YamlMap::Parse(changes, "scenario");
  if (!doc.ok()) return doc.error();
  auto scenario = ReadMerged(Merged(base, YAML::Load(changes)), naming);
  if (scenario.ok() && naming.empty()) scenario.value().name = "scenario";
  return scenario;
}

}  // namespace phs::vehicle
