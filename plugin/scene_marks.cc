#include "plugin/scene_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace phs::plugin {
namespace {

using rail::Side;
using rail::Vec3;

constexpr double kReach = 30;       ///< of the track before and after each wheelset [m]
constexpr double kRailPiece = 1.0;  ///< length of the rails' pieces [m]
constexpr double kSleeperSpacing = 0.65;
constexpr double kRailRadius = 0.036;
constexpr float kRail[4] = {0.45f, 0.42f, 0.40f, 1};
constexpr float kSleeper[4] = {0.62f, 0.60f, 0.56f, 1};
constexpr float kLoad[4] = {0.25f, 0.45f, 0.85f, 1};
constexpr float kGuiding[4] = {0.95f, 0.50f, 0.05f, 1};
constexpr float kForward[4] = {0.10f, 0.62f, 0.30f, 1};
constexpr float kPush[4] = {0.85f, 0.10f, 0.15f, 1};
constexpr float kPull[4] = {0.45f, 0.20f, 0.75f, 1};

/// A fresh shape, or null where the scene is full. mjv_initGeom leaves some fields as they were.
mjvGeom* Next(mjvScene* scene) {
  if (scene->ngeom >= scene->maxgeom) return nullptr;
  mjvGeom* geom = scene->geoms + scene->ngeom;
  *geom = mjvGeom{};
  geom->category = mjCAT_DECOR;
  geom->segid = scene->ngeom++;
  return geom;
}

void Connect(int type, const Vec3& a, const Vec3& b, double width, const float* rgba,
             mjvScene* scene) {
  if (std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) < 0.01) return;
  mjvGeom* geom = Next(scene);
  if (geom == nullptr) return;
  mjv_initGeom(geom, type, nullptr, nullptr, nullptr, rgba);
  mjv_makeConnector(geom, type, width, a[0], a[1], a[2], b[0], b[1], b[2]);
}

/// A point of a track frame, y to the left and z up.
Vec3 At(const rail::TrackFrame& f, double y, double z) {
  Vec3 p = f.origin;
  for (int i = 0; i < 3; ++i) p[i] += f.left[i] * y + f.up[i] * z;
  return p;
}

Vec3 Along(const Vec3& from, const Vec3& direction, double length) {
  return {from[0] + direction[0] * length, from[1] + direction[1] * length,
          from[2] + direction[2] * length};
}

void AddTrack(const rail::Track& track, double begin, double end, mjvScene* scene) {
  for (const double hand : {1.0, -1.0}) {
    const double y = hand * (0.5 * track.gauge() + kRailRadius);
    for (double s = kRailPiece * std::floor(begin / kRailPiece); s < end; s += kRailPiece) {
      Connect(mjGEOM_CAPSULE, At(track.FrameAt(s), y, -kRailRadius),
              At(track.FrameAt(s + kRailPiece), y, -kRailRadius), kRailRadius, kRail, scene);
    }
  }
  for (double s = kSleeperSpacing * std::ceil(begin / kSleeperSpacing); s < end;
       s += kSleeperSpacing) {
    mjvGeom* geom = Next(scene);
    if (geom == nullptr) return;
    const rail::TrackFrame f = track.FrameAt(s);
    const double size[3] = {0.125, 0.5 * track.gauge() + 0.58, 0.05};
    const Vec3 at = At(f, 0, -0.15);
    const double axes[9] = {f.forward[0], f.left[0],    f.up[0],   f.forward[1], f.left[1],
                            f.up[1],      f.forward[2], f.left[2], f.up[2]};
    mjv_initGeom(geom, mjGEOM_BOX, size, at.data(), axes, kSleeper);
  }
}

/// Beside the wheel on its field side, at the height of the rail.
void AddWheelForces(const WheelsetState& state, Side side, double half, mjvScene* scene) {
  const rail::WheelRailForces& wheel = state.wheel[static_cast<int>(side)];
  if (wheel.count == 0) return;
  const double hand = side == Side::kLeft ? 1 : -1;
  const Vec3 force = rail::MirrorPolar(wheel.force, side);
  const rail::TrackFrame& f = state.frame;
  const Vec3 at = At(f, hand * (half + 0.20) + state.lateral, 0.03);
  Connect(mjGEOM_ARROW, at, Along(at, f.up, force[2] * kLoadScale), 0.022, kLoad, scene);
  Connect(mjGEOM_ARROW, at, Along(at, f.left, force[1] * kGuidingScale), 0.022, kGuiding, scene);
  Connect(mjGEOM_ARROW, at, Along(at, f.forward, force[0] * kGuidingScale), 0.022, kForward, scene);
}

void AddCylinderForces(const mjModel* m, const mjData* d, const PhsBinding& phs, mjvScene* scene) {
  for (size_t i = 0; i < phs.cylinder.size(); ++i) {
    const int actuator = phs.cylinder[i];
    if (m->actuator_trntype[actuator] != mjTRN_TENDON) continue;
    const int tendon = m->actuator_trnid[2 * actuator];
    if (d->ten_wrapnum[tendon] < 2) continue;
    const mjtNum* first = d->wrap_xpos + 3 * d->ten_wrapadr[tendon];
    const mjtNum* last = first + 3 * (d->ten_wrapnum[tendon] - 1);
    Vec3 along = {last[0] - first[0], last[1] - first[1], last[2] - first[2]};
    const double length = std::hypot(along[0], along[1], along[2]);
    if (!(length > 0)) continue;
    for (double& x : along) x /= length;
    // The actuator pulls its ends together where its force is negative.
    const double push = d->actuator_force[actuator];
    const Vec3 at = {last[0], last[1], last[2] + 0.15};
    Connect(mjGEOM_ARROW, at, Along(at, along, push * kCylinderScale), 0.022,
            push > 0 ? kPush : kPull, scene);
  }
}

}  // namespace

void AddSceneMarks(const mjModel* m, const mjData* d, const Binding& binding, mjvScene* scene) {
  for (const PhsBinding& phs : binding.phs()) AddCylinderForces(m, d, phs, scene);
  if (!binding.has_rail()) return;
  double begin = std::numeric_limits<double>::infinity();
  double end = -begin;
  for (size_t i = 0; i < binding.wheelsets().size(); ++i) {
    const WheelsetState state = binding.CalcWheelset(m, d, static_cast<int>(i));
    begin = std::min(begin, state.frame.s - kReach);
    end = std::max(end, state.frame.s + kReach);
    const rail::WheelRailParams& params = binding.wheel_rail().params();
    const double half = 0.5 * params.flange_back_distance - params.flange_back_position;
    AddWheelForces(state, Side::kLeft, half, scene);
    AddWheelForces(state, Side::kRight, half, scene);
  }
  if (begin < end) AddTrack(binding.track(), begin, end, scene);
}

}  // namespace phs::plugin
