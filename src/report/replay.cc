#include "report/replay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "report/curving_results.h"
#include "report/decimation.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using SceneJson = nlohmann::json;

/// Five digits are more than the eye sees.
double Short(double value) {
  if (value == 0 || !std::isfinite(value)) return 0;
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 5);
  return std::round(value / unit) * unit;
}

SceneJson Packed(const std::vector<double>& values) {
  const PackedValues packed = Pack(values);
  return {{"least", packed.least}, {"greatest", packed.greatest}, {"packed", packed.base64}};
}

/// A number where nothing changes by more than `grain`.
SceneJson CourseJson(const Course& course, double grain = 1e-5) {
  if (course.empty()) return nullptr;
  const auto [least, most] = std::minmax_element(course.begin(), course.end());
  bool known = true;
  for (const double value : course) known = known && std::isfinite(value);
  if (known && *most - *least <= grain) return Short(0.5 * (*least + *most));
  return Packed(course);
}

template <typename Courses>
SceneJson CoursesJson(const Courses& courses, double grain = 1e-5) {
  SceneJson list = SceneJson::array();
  for (const Course& course : courses) list.push_back(CourseJson(course, grain));
  return list;
}

template <typename T>
std::string Bytes(const std::vector<T>& values) {
  std::vector<unsigned char> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return Base64(bytes);
}

/// Places in 16-bit steps of the mesh's own box, normals in 8 bits, corners in 16 bits.
SceneJson MeshJson(const ReplayMesh& mesh) {
  PHS_CHECK(mesh.vertex.size() == mesh.normal.size() && mesh.vertex.size() < 65536);
  SceneJson vertices = SceneJson::array();
  for (size_t k = 0; k < 3; ++k) {
    std::vector<double> values;
    for (const auto& v : mesh.vertex) values.push_back(v[k]);
    vertices.push_back(Packed(values));
  }
  std::vector<std::int8_t> normals;
  for (const auto& n : mesh.normal) {
    for (const float x : n) {
      normals.push_back(static_cast<std::int8_t>(std::lround(127 * std::clamp(x, -1.0f, 1.0f))));
    }
  }
  std::vector<std::uint16_t> corners;
  for (const auto& f : mesh.face) {
    for (const int i : f) corners.push_back(static_cast<std::uint16_t>(i));
  }
  return {{"vertices", vertices}, {"normals", Bytes(normals)}, {"faces", Bytes(corners)}};
}

SceneJson PartJson(const ReplayPart& part) {
  SceneJson one = {{"kind", part.kind}, {"colour", part.colour}, {"place", SceneJson::array()}};
  one["size"] = {Short(part.size[0]), Short(part.size[1]), Short(part.size[2])};
  if (part.mesh >= 0) one["mesh"] = part.mesh;
  if (part.mirrored) one["mirrored"] = true;
  if (part.alpha < 1) one["alpha"] = Short(part.alpha);
  if (part.body >= 0) one["body"] = part.body;
  for (const auto& look : part.place) one["place"].push_back(CoursesJson(look));
  return one;
}

SceneJson WheelJson(const ReplayWheel& wheel) {
  SceneJson one = {{"name", wheel.name},
                   {"y", CourseJson(wheel.offset_y, 0)},
                   {"z", CourseJson(wheel.offset_z, 0)},
                   {"roll", CourseJson(wheel.roll, 0)},
                   {"patches", SceneJson::array()}};
  for (const ReplayWheel::Patch& patch : wheel.patches) {
    one["patches"].push_back(
        CoursesJson(std::vector<Course>{patch.y, patch.z, patch.angle, patch.a, patch.b,
                                        patch.pressure, patch.load, patch.share},
                    0));
  }
  return one;
}

SceneJson OutlineJson(const std::vector<std::array<double, 2>>& outline) {
  SceneJson points = SceneJson::array();
  for (const auto& p : outline) points.push_back({Short(p[0]), Short(p[1])});
  return points;
}

/// Every text once, and which of them stands at each instant.
SceneJson CaptionJson(const std::string& name, const std::vector<std::string>& values) {
  SceneJson texts = SceneJson::array();
  SceneJson which = SceneJson::array();
  for (const std::string& value : values) {
    if (texts.empty() || texts.back() != value) texts.push_back(value);
    which.push_back(texts.size() - 1);
  }
  return {{"name", name}, {"texts", texts}, {"which", which}};
}

SceneJson BogieJson(const ReplayBogie& bogie) {
  SceneJson one = {{"title", bogie.title},
                   {"last_s", bogie.last_s},
                   {"middle", Packed(bogie.middle_s)},
                   {"bodies", SceneJson::array()},
                   {"parts", SceneJson::array()},
                   {"captions", SceneJson::array()},
                   {"wheel", OutlineJson(bogie.wheel_outline)},
                   {"rail", OutlineJson(bogie.rail_outline)},
                   {"wheels", SceneJson::array()}};
  for (const auto& look : bogie.bodies) {
    SceneJson bodies = SceneJson::array();
    // Turns are small numbers that are seen at the ends of long bodies.
    for (const auto& body : look) bodies.push_back(CoursesJson(body, 1e-6));
    one["bodies"].push_back(std::move(bodies));
  }
  for (const ReplayPart& part : bogie.parts) one["parts"].push_back(PartJson(part));
  for (size_t i = 0; i < bogie.captions.size(); ++i) {
    one["captions"].push_back(CaptionJson(bogie.caption_names[i], bogie.captions[i]));
  }
  for (const ReplayWheel& wheel : bogie.wheels) one["wheels"].push_back(WheelJson(wheel));
  return one;
}

SceneJson ViewsJson(const std::vector<ReplayView>& views) {
  SceneJson list = SceneJson::array();
  for (const ReplayView& view : views) {
    list.push_back(
        {{"name", view.name},
         {"text", view.text},
         {"azimuth", Short(view.azimuth_deg)},
         {"elevation", view.elevation_deg},
         {"distance", Short(view.distance_m)},
         {"target", {Short(view.target[0]), Short(view.target[1]), Short(view.target[2])}}});
  }
  return list;
}

SceneJson WholeJson(const Replay& replay) {
  SceneJson all = {{"begin", replay.begin_s},
                   {"end", replay.end_s},
                   {"points", replay.time.size()},
                   {"time", Packed(replay.time)},
                   {"looks", replay.looks},
                   {"views", ViewsJson(replay.views)},
                   {"colours", SceneJson::array()},
                   {"meshes", SceneJson::array()},
                   {"bogies", SceneJson::array()},
                   {"track",
                    {{"begin", replay.stations_begin_s},
                     {"step", replay.stations_step_m},
                     {"stations", Bytes(replay.stations)},
                     {"rail", replay.rail_mesh},
                     {"bed", replay.bed_mesh},
                     {"sleeper", replay.sleeper},
                     {"sleeper_height", replay.sleeper_height},
                     {"colours", replay.track_colours}}},
                   {"pressures",
                    {{"low", replay.pressure_low_Pa},
                     {"high", replay.pressure_high_Pa},
                     {"colours", replay.pressure_colours}}},
                   {"arrows", replay.arrows}};
  for (const auto& colour : replay.colours) all["colours"].push_back(CoursesJson(colour, 1e-3));
  for (const ReplayMesh& mesh : replay.meshes) all["meshes"].push_back(MeshJson(mesh));
  for (const ReplayBogie& bogie : replay.bogies) all["bogies"].push_back(BogieJson(bogie));
  return all;
}

}  // namespace

std::string ReplayJson(const Replay& replay) {
  return WholeJson(replay).dump(-1, ' ', false, SceneJson::error_handler_t::replace);
}

void AddReplay(const Replay& replay, const CurvingResults& results, ReportPage* page) {
  page->Section("In motion");
  if (!replay.missing.empty()) {
    page->Note("There is no replay: " + replay.missing);
    return;
  }
  SceneJson all = WholeJson(replay);
  const double middle = 0.5 * (results.steady_begin + results.steady_end);
  all["start"] = results.radius > 0 ? std::clamp(middle, replay.begin_s, replay.end_s)
                                    : 0.5 * (replay.begin_s + replay.end_s);
  for (size_t i = 0; i < replay.bogies.size(); ++i) {
    SceneJson& bogie = all["bogies"][i];
    for (const BogieRun& run : results.runs) {
      if (run.name != replay.bogies[i].name) continue;
      bogie["title"] = run.label;
      bogie["colour"] = run.colour;
    }
  }
  page->SetFilm(all.dump(-1, ' ', false, SceneJson::error_handler_t::replace));
  page->AddFigure("replay", "The run again: drag to turn, plots and replay share their place",
                  "{}");
  const bool profiles = std::any_of(replay.bogies.begin(), replay.bogies.end(),
                                    [](const ReplayBogie& b) { return !b.wheels.empty(); });
  if (profiles) {
    page->AddFigure("profiles", "Leading wheels on their rails: contact patches and pressure",
                    "{}");
  }
}

}  // namespace phs::report
