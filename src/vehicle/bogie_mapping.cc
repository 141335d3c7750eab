#include "vehicle/bogie_mapping.h"

#include <algorithm>

#include "base/data_path.h"
#include "base/disk.h"
#include "base/yaml.h"
#include "rail/creep_law.h"

namespace phs::vehicle {
namespace {

const std::vector<std::string>& Directions() {
  static const std::vector<std::string> names = {"x", "y", "z", "roll", "pitch", "yaw"};
  return names;
}

std::vector<SpringDirection> ReadSuspension(YamlMap* parent) {
  std::vector<SpringDirection> springs;
  YamlMap map = parent->Map("suspension");
  for (const std::string& known : Directions()) map.Has(known);  // another key is an error
  for (const std::string& direction : map.Keys()) {
    const auto& known = Directions();
    if (std::find(known.begin(), known.end(), direction) == known.end()) {
      map.Fail(direction, "is no direction", JoinWords(known), DidYouMean(direction, known));
      continue;
    }
    const bool turns = direction.size() > 1;
    YamlMap entry = map.Map(direction);
    SpringDirection s;
    s.direction = direction;
    s.stiffness =
        entry.Number(turns ? "stiffness_Nm_per_rad" : "stiffness_N_per_m", {.min = 0, .max = 1e12});
    s.damping = entry.Number(turns ? "damping_Nms_per_rad" : "damping_Ns_per_m",
                             {.min = 0, .max = 1e9}, 0.0);
    if (direction == "z") s.preload_N = entry.Number("preload_N", {.min = -1e8, .max = 1e8}, 0.0);
    if (s.preload_N != 0 && s.stiffness <= 0) {
      entry.Fail("preload_N", "needs a spring to be carried by", "with stiffness_N_per_m > 0");
    }
    springs.push_back(std::move(s));
  }
  return springs;
}

void ReadPoint(YamlMap* map, const char* key, double* point) {
  const std::vector<double> values = map->Numbers(key, {.min = -100, .max = 100});
  if (values.size() != 3) {
    map->Fail(key, "has " + std::to_string(values.size()) + " values", "three: x, y, z");
    return;
  }
  std::copy(values.begin(), values.end(), point);
}

AxleMapping ReadAxle(YamlMap* map) {
  AxleMapping axle;
  axle.name = map->Text("name");
  axle.boxes = map->Text("boxes");
  axle.wheelset = map->Text("wheelset");
  axle.driven = map->Bool("driven", true);
  axle.rotor_inertia = map->Number("rotor_inertia_kgm2", {.min = 0, .max = 1e5}, 0.0);
  axle.suspension = ReadSuspension(map);
  return axle;
}

}  // namespace

Result<BogieMapping> LoadBogieMapping(const std::string& path) {
  auto doc = YamlMap::Load(path);
  if (!doc.ok()) return doc.error();
  YamlMap& map = doc.value();
  BogieMapping m;
  m.path = path;
  m.name = map.Text("name");
  if (!IsFileName(m.name)) map.Fail("name", Quoted(m.name) + " is no file name", kFileNames);
  m.frame = map.Text("frame");
  if (map.Has("coupler_m")) ReadPoint(&map, "coupler_m", m.coupler_m);
  for (YamlMap entry : map.Maps("axles")) m.axles.push_back(ReadAxle(&entry));
  if (m.axles.empty()) map.Fail("axles", "names no axle", "at least one");
  for (YamlMap entry : map.Maps("sprung")) {
    m.sprung.push_back({entry.Text("link"), ReadSuspension(&entry)});
  }
  for (YamlMap entry : map.Maps("cylinders")) {
    CylinderMapping c;
    c.name = entry.Text("name");
    c.from_link = entry.Text("from_link");
    c.to_link = entry.Text("to_link");
    ReadPoint(&entry, "from_m", c.from_m);
    ReadPoint(&entry, "to_m", c.to_m);
    m.cylinders.push_back(std::move(c));
  }
  const auto file = [&](const char* key, const std::string& otherwise) {
    return Anywhere(BesideFile(path, map.Text(key, otherwise)));
  };
  m.phs = file("phs", m.phs);
  m.yardstick = map.Text("yardstick", "");
  m.wheel_radius_m = map.Number("wheel_radius_m", {.min = 0.1, .max = 2}, m.wheel_radius_m);
  m.flange_back_m = map.Number("flange_back_m", {.min = 0.2, .max = 2}, m.flange_back_m);
  m.timestep_s = map.Number("timestep_s", {.min = 1e-6, .max = 0.05}, m.timestep_s);
  m.track = file("track", "straight");
  m.wheel = file("wheel", "S1002");
  m.rail = file("rail", "UIC60");
  m.creep = map.Word("creep", rail::CreepLawNames(), rail::CreepLawParams{}.method);
  m.speed_m_s = map.Number("speed_m_s", {.min = 0, .max = 120}, 20.0);
  if (Status s = map.Finish(); !s.ok()) return s.error();
  return m;
}

}  // namespace phs::vehicle
