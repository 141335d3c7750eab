#include "view/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "view/shapes.h"
#include "view/view_shapes.h"

namespace phs::view {
namespace {

using Eigen::Vector3d;

constexpr int kMaxGeoms = 4000;

/// Between the lowest and the highest line pressure of the run, rounded outwards to 0.5 MPa.
bool FindPressures(const Recording& recording, PressureScale* scale) {
  constexpr double kRound = 0.5e6;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (size_t i = 0; i < recording.channels.size(); ++i) {
    const std::string& name = recording.channels[i].name;
    if (name.find("line_") == std::string::npos || !name.ends_with("_pressure_Pa")) continue;
    const auto [least, most] =
        std::minmax_element(recording.columns[i].begin(), recording.columns[i].end());
    low = std::min(low, *least);
    high = std::max(high, *most);
  }
  if (!(low <= high)) return false;
  scale->low = kRound * std::floor(low / kRound);
  scale->high = std::max(kRound * std::ceil(high / kRound), scale->low + kRound);
  return true;
}

rail::Side OuterOf(const rail::Track& track) {
  for (const rail::TrackSection& section : track.sections()) {
    if (section.kind == "curve") {
      return section.curvature > 0 ? rail::Side::kRight : rail::Side::kLeft;
    }
  }
  return rail::Side::kRight;
}

}  // namespace

Result<std::unique_ptr<Stage>> Stage::Create(const Recording& recording) {
  auto view = ViewModel::Create(recording.scenario);
  if (!view.ok()) return view.error();
  // Without these nobody knows where a wheelset stood.
  for (const plugin::WheelsetBinding& w : view.value().binding().wheelsets()) {
    for (const char* what : {"_x_m", "_y_m", "_lateral_m", "_angle_of_attack_rad"}) {
      if (recording.Find(w.name + what) >= 0) continue;
      return Error{recording.label, "has no channel " + w.name + what,
                   "a result of this bogie, as phs writes it", "run it again with --out"};
    }
  }
  return std::unique_ptr<Stage>(new Stage(recording, std::move(view).value()));
}

Stage::Stage(const Recording& recording, ViewModel view)
    : recording_(recording),
      view_(std::move(view)),
      data_(mj_makeData(view_.model())),
      poser_(view_.model(), view_.binding(), recording) {
  picture_.model = &view_;
  picture_.d = data_.get();
  picture_.recording = &recording_;
  has_pressures_ = FindPressures(recording, &picture_.pressures);
  outer_ = OuterOf(view_.binding().track());
  // Near plane, far plane, shadow and fog are multiples of this length.
  view_.model()->stat.extent = 3;
  for (double& x : view_.model()->stat.center) x = 0;
  mjv_defaultScene(&scene_);
  mjv_makeScene(view_.model(), &scene_, kMaxGeoms);
  scene_.flags[mjRND_SHADOW] = 1;
  scene_.flags[mjRND_REFLECTION] = 0;
  scene_.flags[mjRND_FOG] = 1;
  scene_.flags[mjRND_HAZE] = 1;
  mjv_defaultOption(&option_);
  option_.flags[mjVIS_TENDON] = 0;
  option_.flags[mjVIS_ACTUATOR] = 0;
  option_.flags[mjVIS_STATIC] = 1;
  for (mjtByte& group : option_.sitegroup) group = 0;
  mjr_defaultContext(&context_);
}

Stage::~Stage() {
  if (has_context_) mjr_freeContext(&context_);
  mjv_freeScene(&scene_);
}

void Stage::UseContext(int width, int height) {
  view_.model()->vis.global.offwidth = width;
  view_.model()->vis.global.offheight = height;
  const int font = height < 500 ? mjFONTSCALE_50 : height < 900 ? mjFONTSCALE_100 : mjFONTSCALE_150;
  mjr_makeContext(view_.model(), &context_, font);
  has_context_ = true;
}

void Stage::SetMoment(double time, const Look& look) {
  mjModel* m = view_.model();
  mjData* d = data_.get();
  picture_.at = recording_.At(time);
  // A film looks at each moment twice: as it was, and magnified.
  if (posed_.empty() || time != posed_time_) {
    poser_.Pose(picture_.at, d);
    posed_.assign(d->qpos, d->qpos + m->nq);
    posed_time_ = time;
  }
  mju_copy(d->qpos, posed_.data(), m->nq);
  picture_.s = poser_.MiddleOfVehicle(picture_.at);
  const rail::Track& track = view_.binding().track();
  picture_.origin = Vector3d::Zero();
  // The place under the vehicle becomes zero: the renderer's numbers are short ones.
  if (m->njnt > 0 && m->jnt_type[0] == mjJNT_FREE) {
    picture_.origin = ToEigen(track.FrameAt(picture_.s).origin);
    for (int i = 0; i < 3; ++i) d->qpos[i] -= picture_.origin[i];
  }
  mj_kinematics(m, d);
  mj_camlight(m, d);
  if (look.parts_only) poser_.StopWheels(d);
  Magnify(m, track, picture_.origin, look.magnify, d);
  option_.geomgroup[kPhysicsGroup] = 1;
  option_.geomgroup[1] = 1;
  option_.geomgroup[kBodyGroup] = look.body ? 1 : 0;
  mjvCamera camera;
  mjv_defaultFreeCamera(m, &camera);
  mjv_updateScene(m, d, &option_, nullptr, &camera, mjCAT_ALL, &scene_);
  // What is looked at from near lies in the wheel's shadow.
  scene_.flags[mjRND_SHADOW] = look.contacts ? 0 : 1;
  Pen pen(&scene_);
  pen.KeepPlaces(look.parts_only);
  track_begin_ = scene_.ngeom;
  if (!look.parts_only) DrawTrack(picture_, &pen);
  track_end_ = scene_.ngeom;
  DrawAll(look, &pen);
}

void Stage::DrawAll(const Look& look, Pen* pen) {
  DrawRunningGear(picture_, look.contacts, pen);
  if (!look.parts_only) DrawCoils(picture_, pen);
  DrawLines(picture_, pen);
  if (look.forces && !look.contacts) DrawForces(picture_, pen);
  if (look.contacts) DrawContacts(picture_, pen);
}

void Stage::AddGhost(Stage* ghost, const Look& look) {
  constexpr float kAlpha = 0.35f;
  Look bare = look;
  bare.forces = bare.contacts = false;
  ghost->SetMoment(ghost->recording_.TimeAt(picture_.Value("s_m")), bare);
  const Vector3d shift = ghost->picture_.origin - picture_.origin;
  for (int i = 0; i < ghost->scene_.ngeom && scene_.ngeom < scene_.maxgeom; ++i) {
    if (i >= ghost->track_begin_ && i < ghost->track_end_) continue;
    mjvGeom geom = ghost->scene_.geoms[i];
    if (geom.type == mjGEOM_MESH) {
      // Meshes belong to a context: wheels are there under this model's own numbers, coils are not.
      const int slot = geom.dataid / 2 - ghost->view_.MeshId(MeshSlot::kWheelLeft);
      if (slot != 0 && slot != 1) continue;
      geom.dataid = 2 * view_.MeshId(static_cast<MeshSlot>(slot));
    }
    for (int k = 0; k < 3; ++k) {
      geom.pos[k] += static_cast<float>(shift[k]);
      geom.rgba[k] = 0.5f * geom.rgba[k] + (k == 0 ? 0.45f : 0.1f);
    }
    geom.rgba[3] *= kAlpha;
    // A skin about what stands at the same place, so that neither flickers through the other.
    for (float& size : geom.size) size *= 1.01f;
    geom.transparent = 1;
    scene_.geoms[scene_.ngeom++] = geom;
  }
}

void Stage::Render(const mjvCamera& camera, const mjrRect& viewport) {
  mjvCamera own = camera;
  mjv_updateCamera(view_.model(), data_.get(), &own, &scene_);
  for (int i = 0; i < static_cast<int>(MeshSlot::kCount); ++i) {
    const MeshSlot slot = static_cast<MeshSlot>(i);
    if (view_.TakeChanged(slot)) mjr_uploadMesh(view_.model(), &context_, view_.MeshId(slot));
  }
  mjr_render(viewport, &scene_, &context_);
}

}  // namespace phs::view
