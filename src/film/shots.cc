#include "film/shots.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "base/numbers.h"
#include "view/palette.h"
#include "view/shapes.h"

namespace phs::film {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using report::Course;

constexpr double kStill = 2e-4;  ///< a place that moves less against a body belongs to it [m]

const char* SolidName(int type) {
  switch (type) {
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_SPHERE:
    case mjGEOM_ELLIPSOID:
      return "ball";
    case mjGEOM_MESH:
      return "mesh";
    default:
      return nullptr;
  }
}

const char* BarName(int type) {
  switch (type) {
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ARROW:
      return "arrow";
    default:
      return nullptr;
  }
}

/// World axes about picture.origin to L.
struct ToL {
  Matrix3d turn;
  explicit ToL(const view::Picture& picture) {
    const rail::TrackFrame frame = picture.model->binding().track().FrameAt(picture.s);
    turn = Eigen::AngleAxisd(-frame.heading, Vector3d::UnitZ()).toRotationMatrix();
  }
};

Matrix3d AxesOf(const float* mat) {
  return Eigen::Map<const Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(mat).cast<double>();
}

/// False for what a film does not show.
bool ShotOf(const mjvGeom& geom, const view::Picture& picture, const ToL& to_l, Shot* shot) {
  const Vector3d at = to_l.turn * Eigen::Map<const Eigen::Vector3f>(geom.pos).cast<double>();
  const Matrix3d axes = to_l.turn * AxesOf(geom.mat);
  for (size_t k = 0; k < 4; ++k) shot->colour[k] = geom.rgba[k];
  shot->size = Eigen::Map<const Eigen::Vector3f>(geom.size).cast<double>();
  shot->a = at;
  shot->axes = axes;
  if (geom.type == mjGEOM_NONE) {
    shot->visible = false;
    return true;
  }
  if (const char* bar = BarName(geom.type)) {
    shot->kind = bar;
    // The engine's cylinders stand about their middle, its arrows begin at their foot.
    const bool arrow = geom.type == mjGEOM_ARROW;
    const Vector3d along = axes.col(2) * shot->size.z();
    shot->a = arrow ? at : Vector3d(at - along);
    shot->b = at + along;
    return true;
  }
  const char* solid = SolidName(geom.type);
  if (solid == nullptr) return false;
  shot->kind = solid;
  if (geom.type == mjGEOM_SPHERE) shot->size = Vector3d::Constant(shot->size.x());
  if (geom.type == mjGEOM_MESH) {
    shot->mesh = geom.dataid / 2;
    shot->mirrored = shot->mesh == picture.model->MeshId(view::MeshSlot::kWheelRight);
    if (shot->mirrored) shot->mesh = picture.model->MeshId(view::MeshSlot::kWheelLeft);
  }
  return true;
}

std::vector<Shot> CoilShots(const view::Picture& picture, const ToL& to_l, size_t first_mesh) {
  std::vector<Shot> shots;
  for (const view::CoilSpan& coil : view::CoilsOf(picture)) {
    Shot shot;
    shot.kind = "coil";
    shot.mesh = static_cast<int>(first_mesh);
    shot.size = {coil.radius, coil.wire, 0};
    const view::Colour& c = view::kCoilColour;
    shot.colour = {c.r, c.g, c.b, c.a};
    shot.a = to_l.turn * coil.a;
    shot.b = to_l.turn * coil.b;
    shots.push_back(shot);
  }
  return shots;
}

bool IsBar(const Shot& shot) {
  return shot.kind != "box" && shot.kind != "ball" && shot.kind != "mesh";
}

/// Place of a shape in the axes of a body, or in L without one.
Eigen::VectorXd PlaceOf(const Shot& shot, const Pose* body, bool bar) {
  const Matrix3d turn = body == nullptr ? Matrix3d::Identity() : Matrix3d(body->axes.transpose());
  const Vector3d origin = body == nullptr ? Vector3d::Zero() : body->origin;
  Eigen::VectorXd place(bar ? 6 : 7);
  if (bar) {
    place << turn * (shot.a - origin), turn * (shot.b - origin);
  } else {
    // A round ball has no attitude.
    const bool round =
        shot.kind == "ball" && shot.size.x() == shot.size.y() && shot.size.y() == shot.size.z();
    const Quaterniond q(round ? Matrix3d::Identity() : Matrix3d(turn * shot.axes));
    place << turn * (shot.a - origin), q.w(), q.x(), q.y(), q.z();
  }
  return place;
}

/// Quaternions that follow each other stay on one side.
void Join(const Eigen::VectorXd& before, Eigen::VectorXd* place) {
  if (place->size() == 7 && before.tail(4).dot(place->tail(4)) < 0) place->tail(4) *= -1;
}

/// True if no instant of any look finds the shape elsewhere on the body.
bool IsCarried(const std::vector<std::vector<Instant>>& instants, size_t part, size_t body,
               bool bar) {
  Eigen::VectorXd first;
  for (const auto& look : instants) {
    for (const Instant& instant : look) {
      const Shot& shot = instant.shots[part];
      if (!shot.visible) return false;
      Eigen::VectorXd place = PlaceOf(shot, &instant.bodies[body], bar);
      if (first.size() == 0) first = place;
      Join(first, &place);
      if (((place - first).cwiseAbs().array() > kStill).any()) return false;
    }
  }
  return true;
}

/// The body that carries a part, -1 for none.
int CarrierOf(const std::vector<std::vector<Instant>>& instants, size_t part, bool bar) {
  for (size_t body = 1; body < instants[0][0].bodies.size(); ++body) {
    if (IsCarried(instants, part, body, bar)) return static_cast<int>(body);
  }
  return -1;
}

std::vector<Course> PlacesInL(const std::vector<Instant>& look, size_t part, bool bar) {
  std::vector<Course> place(bar ? 6 : 7);
  Eigen::VectorXd before;
  for (const Instant& instant : look) {
    const Shot& shot = instant.shots[part];
    if (!shot.visible) {
      for (Course& course : place) course.push_back(kNoNumber);
      continue;
    }
    Eigen::VectorXd now = PlaceOf(shot, nullptr, bar);
    if (before.size() > 0) Join(before, &now);
    for (size_t k = 0; k < place.size(); ++k) place[k].push_back(now[static_cast<long>(k)]);
    before = now;
  }
  return place;
}

std::array<Course, 3> ColourOf(const std::vector<Instant>& look, size_t part) {
  std::array<Course, 3> colour;
  const Shot* last = nullptr;
  for (const Instant& instant : look) {
    if (instant.shots[part].visible) {
      last = &instant.shots[part];
      break;
    }
  }
  for (const Instant& instant : look) {
    if (instant.shots[part].visible) last = &instant.shots[part];
    for (size_t k = 0; k < 3; ++k) colour[k].push_back(last == nullptr ? 0 : last->colour[k]);
  }
  return colour;
}

/// A shape that is seen at least once; null if never.
const Shot* SeenOnce(const std::vector<std::vector<Instant>>& instants, size_t part) {
  for (const auto& look : instants) {
    for (const Instant& instant : look) {
      if (instant.shots[part].visible) return &instant.shots[part];
    }
  }
  return nullptr;
}

std::array<Course, 7> BodyCourse(const std::vector<Instant>& look, size_t body) {
  std::array<Course, 7> courses;
  Eigen::VectorXd before;
  for (const Instant& instant : look) {
    const Quaterniond q(instant.bodies[body].axes);
    Eigen::VectorXd place(7);
    place << instant.bodies[body].origin, q.w(), q.x(), q.y(), q.z();
    if (before.size() > 0) Join(before, &place);
    for (size_t k = 0; k < 7; ++k) courses[k].push_back(place[static_cast<long>(k)]);
    before = place;
  }
  return courses;
}

}  // namespace

Instant TakeApart(view::Stage* stage) {
  const view::Picture& picture = stage->picture();
  const ToL to_l(picture);
  Instant instant;
  const mjvScene* scene = stage->scene();
  for (int i = 0; i < scene->ngeom; ++i) {
    Shot shot;
    if (ShotOf(scene->geoms[i], picture, to_l, &shot)) instant.shots.push_back(shot);
  }
  const auto coils =
      CoilShots(picture, to_l, static_cast<size_t>(picture.model->MeshId(view::MeshSlot::kCoils)));
  instant.shots.insert(instant.shots.end(), coils.begin(), coils.end());
  for (int body = 0; body < stage->model()->nbody; ++body) {
    instant.bodies.push_back(
        {to_l.turn * picture.BodyAt(body), to_l.turn * picture.BodyAxes(body)});
  }
  return instant;
}

int Colours::Add(const std::array<Course, 3>& course) {
  const auto at = std::find(courses_.begin(), courses_.end(), course);
  const auto number = static_cast<int>(at - courses_.begin());
  if (at == courses_.end()) courses_.push_back(course);
  return number;
}

void AddParts(const std::vector<std::vector<Instant>>& instants, Colours* colours,
              report::ReplayBogie* bogie) {
  const size_t count = instants[0][0].shots.size();
  std::vector<int> number(instants[0][0].bodies.size(), -1);  // of a body among those that carry
  std::vector<size_t> used;
  for (size_t i = 0; i < count; ++i) {
    for (const auto& look : instants) {
      for (const Instant& instant : look) PHS_CHECK(instant.shots.size() == count);
    }
    const Shot* shot = SeenOnce(instants, i);
    if (shot == nullptr) continue;
    const bool bar = IsBar(*shot);
    report::ReplayPart part;
    part.kind = shot->kind;
    part.mesh = shot->mesh;
    part.mirrored = shot->mirrored;
    part.size = {shot->size.x(), shot->size.y(), shot->size.z()};
    part.alpha = shot->colour[3];
    part.colour = colours->Add(ColourOf(instants[0], i));
    const int carrier = CarrierOf(instants, i, bar);
    if (carrier < 0) {
      for (const auto& look : instants) part.place.push_back(PlacesInL(look, i, bar));
    } else {
      const auto body = static_cast<size_t>(carrier);
      if (number[body] < 0) {
        number[body] = static_cast<int>(used.size());
        used.push_back(body);
      }
      part.body = number[body];
      const Eigen::VectorXd place =
          PlaceOf(instants[0][0].shots[i], &instants[0][0].bodies[body], bar);
      part.place.emplace_back();
      for (const double value : place) part.place[0].push_back({value});
    }
    bogie->parts.push_back(std::move(part));
  }
  for (const auto& look : instants) {
    bogie->bodies.emplace_back();
    for (const size_t body : used) bogie->bodies.back().push_back(BodyCourse(look, body));
  }
}

}  // namespace phs::film
