#include "film/track_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "view/palette.h"
#include "view/shapes.h"

namespace phs::film {
namespace {

using Eigen::Vector3d;
using rail::Side;

constexpr double kBeyond = 45;  ///< track before and behind the run [m]
constexpr double kMostStations = 4000;

std::array<double, 3> Rgb(const view::Colour& c) { return {c.r, c.g, c.b}; }

/// A section one metre long along x.
view::Mesh OneMetre(const view::Section& section) {
  const Vector3d left = Vector3d::UnitY();
  const Vector3d up = Vector3d::UnitZ();
  return view::Sweep(section, {{Vector3d::Zero(), left, up}, {Vector3d::UnitX(), left, up}});
}

void AddStation(const view::Picture& picture, double s, std::vector<float>* stations) {
  const plugin::Binding& binding = picture.model->binding();
  const rail::TrackFrame frame = binding.track().FrameAt(s);
  const auto add = [&](double value) { stations->push_back(static_cast<float>(value)); };
  for (const rail::Vec3& v : {frame.origin, frame.left, frame.up}) {
    for (const double x : v) add(x);
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double hand = side == Side::kLeft ? 1 : -1;
    const rail::RailOffset offset = binding.track().Rail(side, s);
    add(hand * view::RailPosition(binding.wheel_rail()) + offset.lateral);
    add(offset.vertical);
  }
}

}  // namespace

report::ReplayMesh PlainMesh(const view::Mesh& mesh) {
  report::ReplayMesh plain;
  for (const auto& v : mesh.vertex) plain.vertex.push_back({v.x(), v.y(), v.z()});
  for (const auto& n : mesh.normal) plain.normal.push_back({n.x(), n.y(), n.z()});
  plain.face = mesh.face;
  return plain;
}

void AddTrack(const view::Stage& stage, double begin_s, double end_s, report::Replay* replay) {
  const view::Picture& picture = stage.picture();
  const rail::Track& track = picture.model->binding().track();
  const double length = end_s - begin_s + 2 * kBeyond;
  replay->stations_begin_s = begin_s - kBeyond;
  // A sleeper at each; farther apart on a long way, where the page has no room for them all.
  replay->stations_step_m = std::max(view::kSleeperSpacing, length / kMostStations);
  const int count = static_cast<int>(length / replay->stations_step_m) + 1;
  for (int i = 0; i < count; ++i) {
    AddStation(picture, replay->stations_begin_s + i * replay->stations_step_m, &replay->stations);
  }
  const auto add = [&](const view::Section& section) {
    replay->meshes.push_back(PlainMesh(OneMetre(section)));
    return static_cast<int>(replay->meshes.size()) - 1;
  };
  replay->rail_mesh = add(picture.model->rail_section());
  replay->bed_mesh = add(view::BallastSection(track));
  replay->sleeper = {view::kSleeperHalfWidth, view::SleeperHalfLength(track),
                     view::kSleeperHalfHeight};
  replay->sleeper_height = view::kSleeperTop - view::kSleeperHalfHeight;
  replay->track_colours = {Rgb(view::kRailColour), Rgb(view::kSleeperColour),
                           Rgb(view::kBallastColour)};
}

void AddViews(const view::Stage& stage, report::Replay* replay) {
  const view::Picture& picture = stage.picture();
  const rail::TrackFrame frame = picture.model->binding().track().FrameAt(picture.s);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(-frame.heading, Vector3d::UnitZ()).toRotationMatrix();
  for (const view::View& view : view::Views()) {
    if (view.target == view::Target::kContact) continue;  // has a drawing of its own
    const mjvCamera camera = stage.CameraOf(view);
    const Vector3d target = turn * Vector3d(camera.lookat[0], camera.lookat[1], camera.lookat[2]);
    replay->views.push_back({view.name,
                             view.text,
                             camera.azimuth - frame.heading * 180 / M_PI,
                             camera.elevation,
                             camera.distance,
                             {target.x(), target.y(), target.z()}});
  }
}

std::string ArrowsText(bool cylinders) {
  std::string text = fmt::format(
      "Arrows on the wheels: blue Q (100 kN = {:g} m), orange Y and green X (10 kN = {:g} m)",
      1e5 * view::kLoadScale, 1e4 * view::kGuidingScale);
  if (cylinders) {
    text +=
        fmt::format("; at the axle boxes the cylinders, red pushes, violet pulls (10 kN = {:g} m)",
                    1e4 * view::kCylinderScale);
  }
  return text + ".";
}

}  // namespace phs::film
