#include "vehicle/scenario.h"

#include <filesystem>

#include "base/data_path.h"
#include "base/yaml.h"
#include "rail/creep_law.h"

namespace phs::vehicle {

Result<Scenario> LoadScenario(const std::string& name_or_path) {
  auto path = FindData("scenario", "models/scenarios", name_or_path, {".yaml"});
  if (!path.ok()) return path.error();
  auto doc = YamlMap::Load(path.value());
  if (!doc.ok()) return doc.error();
  YamlMap& map = doc.value();

  Scenario s;
  s.name = std::filesystem::path(path.value()).stem().string();
  s.track = map.Text("track");
  s.bogie = map.Text("bogie", s.bogie);
  s.vehicle = map.Word("vehicle", {"bogie", "locomotive"}, s.vehicle);
  s.wheel = map.Text("wheel", s.wheel);
  s.rail = map.Text("rail", s.rail);
  if (map.Has("creep")) s.creep = map.Word("creep", rail::CreepLawNames());
  s.phs = map.Text("phs", s.phs);
  if (map.Has("speed_m_s")) {
    s.speed_m_s = map.Number("speed_m_s", {.min = 1, .max = 120});
    if (map.Has("speed_km_h")) map.Fail("speed_km_h", "repeats speed_m_s", "one of the two");
  } else {
    s.speed_m_s = map.Number("speed_km_h", {.min = 3.6, .max = 432}) / 3.6;
  }
  s.friction = map.Number("friction", {.min = 0.01, .max = 1.0}, s.friction);
  s.flange_friction = map.Number("flange_friction", {.min = 0.01, .max = 1.0}, s.flange_friction);
  s.timestep_s = map.Number("timestep_s", {.min = 1e-6, .max = 0.05}, s.timestep_s);
  s.duration_s = map.Number("duration_s", {.min = 0, .max = 1e5, .open_min = true}, s.duration_s);
  s.start_s_m = map.Number("start_s_m", {.min = -1e4, .max = 1e7}, s.start_s_m);
  s.record_interval_s =
      map.Number("record_interval_s", {.min = 1e-6, .max = 60}, s.record_interval_s);
  s.failures = effects::ReadFailures(&map, s.speed_m_s, s.start_s_m);
  if (Status status = map.Finish(); !status.ok()) return status.error();
  return s;
}

}  // namespace phs::vehicle
