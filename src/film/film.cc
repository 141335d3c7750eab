#include "film/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "film/contact_film.h"
#include "film/shots.h"
#include "film/track_film.h"
#include "view/captions.h"
#include "view/palette.h"
#include "view/shapes.h"

namespace phs::film {
namespace {

using report::Replay;
using report::ReplayBogie;
using report::ReplayMesh;

/// How the bogies may be drawn: as they stand, and so that a thousandth of a radian can be seen.
struct NamedLook {
  const char* name;
  view::Magnification magnify;
};
constexpr NamedLook kLooks[] = {{"as it was", {1, 1}}, {"angles × 20, shifts × 5", {20, 5}}};

view::Look LookOf(const NamedLook& named) {
  view::Look look;
  look.magnify = named.magnify;
  look.parts_only = true;
  return look;
}

/// The bogie that the report compares with comes first there, too.
void SortAsReport(std::vector<view::Recording>* recordings) {
  std::stable_sort(recordings->begin(), recordings->end(), [](const auto& a, const auto& b) {
    return (a.label == "phs") > (b.label == "phs");
  });
}

struct Way {
  double begin = 0, end = 0;
};
Way WayOf(const std::vector<view::Recording>& recordings) {
  Way way{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const view::Recording& recording : recordings) {
    const auto& s = recording.columns[static_cast<size_t>(recording.Find("s_m"))];
    way.begin = std::min(way.begin, s.front());
    way.end = std::max(way.end, s.back());
  }
  return way;
}

/// A mesh of the model, once in the page however many bogies roll on it.
int AddMesh(const ReplayMesh& mesh, std::vector<ReplayMesh>* meshes) {
  const auto at = std::find(meshes->begin(), meshes->end(), mesh);
  const auto number = static_cast<int>(at - meshes->begin());
  if (at == meshes->end()) meshes->push_back(mesh);
  return number;
}

ReplayMesh MeshOf(const mjModel* m, int id) {
  ReplayMesh mesh;
  const auto triple = [](const auto* from, int i) {
    return std::array{from[3 * i], from[3 * i + 1], from[3 * i + 2]};
  };
  for (int i = 0; i < m->mesh_vertnum[id]; ++i) {
    mesh.vertex.push_back(triple(m->mesh_vert + 3 * m->mesh_vertadr[id], i));
    mesh.normal.push_back(triple(m->mesh_normal + 3 * m->mesh_vertadr[id], i));
  }
  for (int i = 0; i < m->mesh_facenum[id]; ++i) {
    mesh.face.push_back(triple(m->mesh_face + 3 * m->mesh_faceadr[id], i));
  }
  return mesh;
}

/// Meshes of the parts: numbers of the model become numbers of the page.
void AddMeshes(const mjModel* m, ReplayBogie* bogie, std::vector<ReplayMesh>* meshes) {
  for (report::ReplayPart& part : bogie->parts) {
    if (part.mesh < 0) continue;
    if (part.kind == "coil") {
      const view::Mesh coil =
          view::Coil({0, 0, 0}, {0, 0, 1}, part.size[0], part.size[1], view::kCoilTurns);
      part.mesh = AddMesh(PlainMesh(coil), meshes);
    } else {
      part.mesh = AddMesh(MeshOf(m, part.mesh), meshes);
    }
  }
}

Result<ReplayBogie> FilmBogie(const view::Recording& recording, const Way& way, size_t count,
                              Replay* replay, Colours* colours) {
  auto created = view::Stage::Create(recording);
  if (!created.ok()) return created.error();
  view::Stage* stage = created.value().get();
  ReplayBogie bogie;
  bogie.name = recording.label;
  bogie.title = view::TitleOf(recording);
  bogie.last_s = recording.Value("s_m", recording.At(recording.end_s()));
  const bool first = replay->bogies.empty();
  const auto law = LawOfRun(*stage->picture().model, recording.scenario);
  if (!law.ok()) return law.error();
  ContactFilm contacts(*stage->picture().model, law.value());
  std::vector<std::vector<Instant>> instants(std::size(kLooks));
  for (size_t k = 0; k < count; ++k) {
    const double s =
        way.begin + (way.end - way.begin) * static_cast<double>(k) / static_cast<double>(count - 1);
    const double time = recording.TimeAt(s);
    for (size_t l = 0; l < instants.size(); ++l) {
      const view::Look look = LookOf(kLooks[l]);
      stage->SetMoment(time, look);
      instants[l].push_back(TakeApart(stage));
      if (l > 0) continue;
      contacts.Add(stage->picture());
      bogie.middle_s.push_back(stage->picture().s);
      if (first) replay->time.push_back(time);
      const auto lines = view::CaptionsOf(*stage, look);
      bogie.captions.resize(lines.size());
      bogie.caption_names.resize(lines.size());
      for (size_t i = 0; i < lines.size(); ++i) {
        bogie.caption_names[i] = lines[i].name;
        bogie.captions[i].push_back(lines[i].value);
      }
    }
  }
  AddParts(instants, colours, &bogie);
  AddMeshes(stage->model(), &bogie, &replay->meshes);
  contacts.Finish(&bogie);
  if (first) {
    AddTrack(*stage, way.begin, way.end, replay);
    stage->SetMoment(replay->time.front(), LookOf(kLooks[0]));
    AddViews(*stage, replay);
  }
  if (stage->has_pressures()) {
    const view::PressureScale& scale = stage->picture().pressures;
    replay->pressure_low_Pa = scale.low;
    replay->pressure_high_Pa = scale.high;
    replay->pressure_colours.clear();
    for (int i = 0; i <= 8; ++i) {
      const view::Colour c = view::ScaleColour(i / 8.0);
      replay->pressure_colours.push_back({c.r, c.g, c.b});
    }
  }
  return bogie;
}

Result<Replay> FilmAll(const std::vector<view::Recording>& recordings, size_t count) {
  const Way way = WayOf(recordings);
  Replay replay;
  replay.begin_s = way.begin;
  replay.end_s = way.end;
  for (const NamedLook& look : kLooks) replay.looks.emplace_back(look.name);
  Colours colours;
  for (const view::Recording& recording : recordings) {
    auto bogie = FilmBogie(recording, way, count, &replay, &colours);
    if (!bogie.ok()) return bogie.error();
    replay.bogies.push_back(std::move(bogie).value());
  }
  replay.colours = colours.Take();
  replay.arrows = ArrowsText(replay.pressure_high_Pa > replay.pressure_low_Pa);
  return replay;
}

}  // namespace

Result<Replay> MakeFilm(const std::string& dir, const FilmOptions& options) {
  auto loaded = view::LoadRecordings(dir);
  if (!loaded.ok()) return loaded.error();
  std::vector<view::Recording>& recordings = loaded.value();
  if (recordings.empty()) {
    return Error{dir, "holds no bogie", "a result of simulate or compare", "run it again"};
  }
  SortAsReport(&recordings);
  const Way way = WayOf(recordings);
  if (!(way.end - way.begin > options.spacing_m)) {
    return Error{dir, "moves less than a metre", "a run along the track", ""};
  }
  double count = std::min((way.end - way.begin) / options.spacing_m, 1.0 * options.most_instants);
  for (;;) {
    count = std::max(20.0, count);
    auto film = FilmAll(recordings, static_cast<size_t>(count));
    if (!film.ok()) return film.error();
    // Nearly all bytes are courses, so they shrink with the number of instants.
    const auto bytes = static_cast<double>(report::ReplayJson(film.value()).size());
    if (bytes <= options.most_bytes || count <= 20) return film;
    count *= 0.95 * options.most_bytes / bytes;
  }
}

Replay FilmOrReason(const std::string& dir) {
  auto film = MakeFilm(dir);
  if (film.ok()) return std::move(film).value();
  Replay none;
  none.missing = film.error().Line();
  return none;
}

}  // namespace phs::film
