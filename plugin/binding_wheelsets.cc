// The part of Binding that presses wheelsets on the track. No allocation, no locks, no exceptions.
#include <algorithm>
#include <cmath>
#include <new>

#include "base/wide.h"
#include "plugin/binding_work.h"
#include "plugin/dof_chain.h"
#include "plugin/kept_wheelsets.h"
#include "plugin/spatial.h"

namespace phs::plugin {
namespace {

using rail::Side;
using rail::Vec3;

Vec3 ToTrack(const rail::TrackFrame& f, const Vec3& v) {
  return {Dot(f.forward, v), Dot(f.left, v), Dot(f.up, v)};
}
Vec3 ToWorld(const rail::TrackFrame& f, const Vec3& v) {
  Vec3 w;
  for (int i = 0; i < 3; ++i) w[i] = f.forward[i] * v[0] + f.left[i] * v[1] + f.up[i] * v[2];
  return w;
}
/// Position and attitude of a wheelset in T axes (speeds and forces still empty).
void PlaceOnTrack(const mjData* d, const rail::Track& track, int body, WheelsetState* out) {
  out->centre = Load(d->xpos + 3 * body);
  out->frame = track.FrameAt(track.Project(out->centre));
  Vec3 offset = out->centre;
  for (int i = 0; i < 3; ++i) offset[i] -= out->frame.origin[i];
  out->lateral = Dot(out->frame.left, offset);
  out->vertical = Dot(out->frame.up, offset);
  const mjtNum* r = d->xmat + 9 * body;
  const Vec3 axle = ToTrack(out->frame, {r[1], r[4], r[7]});
  out->yaw = std::atan2(-axle[0], axle[1]);
  out->roll = std::asin(std::clamp(axle[2], -1.0, 1.0));
}

PHS_WITHIN_WIDE void LoadVec3(const Vec3& v, Lanes* out) { *out = Lanes{v[0], v[1], v[2], 0}; }

/// Adds `scale` times the dampers of a wheel, about the point from which `arm` leads to the
/// wheelset's centre; world axes.
PHS_WIDE void AddDampers(const rail::WheelDamping& dampers, Side side,
                         const rail::TrackFrame& frame, const Vec3& arm, double scale,
                         SpatialMatrix* sum) {
  Lanes forward, left, up, lever;
  LoadVec3(frame.forward, &forward);
  LoadVec3(frame.left, &left);
  LoadVec3(frame.up, &up);
  LoadVec3(arm, &lever);
  for (int k = 0; k < dampers.count; ++k) {
    const auto& damper = dampers.damper[static_cast<size_t>(k)];
    const Vec3 moment = rail::MirrorAxial(damper.moment, side);
    const Vec3 force = rail::MirrorPolar(damper.force, side);
    Spatial g;
    g.first = moment[0] * forward + moment[1] * left + moment[2] * up;
    g.second = force[0] * forward + force[1] * left + force[2] * up;
    AddCross(lever, g.second, &g.first);
    const double scaled = scale * damper.coefficient;
    for (size_t i = 0; i < 3; ++i) {
      AddScaledSpatial(scaled * g.first[i], g, &(*sum)[i]);
      AddScaledSpatial(scaled * g.second[i], g, &(*sum)[3 + i]);
    }
  }
}

}  // namespace

PHS_WIDE BodyVelocity VelocityOf(const mjModel* m, const mjData* d, int body,
                                 const std::vector<int>& dofs, const double* speed) {
  Spatial v, c;
  for (const int dof : dofs) {
    LoadSix(d->cdof + 6 * dof, &c);
    AddScaledSpatial(speed[dof], c, &v);
  }
  const mjtNum* centre = d->xpos + 3 * body;
  const mjtNum* com = d->subtree_com + 3 * m->body_rootid[body];
  const Lanes arm = {centre[0] - com[0], centre[1] - com[1], centre[2] - com[2], 0};
  AddCross(v.first, arm, &v.second);
  return {{v.first[0], v.first[1], v.first[2]}, {v.second[0], v.second[1], v.second[2]}};
}

PHS_WIDE void AddWrench(const mjData* d, const std::vector<int>& dofs, const Vec3& force,
                        const Vec3& moment, double* out) {
  const Spatial wrench{{moment[0], moment[1], moment[2], 0}, {force[0], force[1], force[2], 0}};
  Spatial c;
  for (const int dof : dofs) {
    LoadSix(d->cdof + 6 * dof, &c);
    out[dof] += DotSpatial(c, wrench);
  }
}

void Binding::PressWheelset(const mjData* d, int index, PressedWheelset* at) const noexcept {
  WheelsetState& out = at->state;
  PlaceOnTrack(d, *track_, wheelsets_[index].body, &out);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Vec3 place = rail::MirrorPolar({0, out.lateral, out.vertical}, side);
    const Vec3 attitude = rail::MirrorAxial({out.roll, 0, out.yaw}, side);
    rail::WheelsetMotion& motion = at->motion[static_cast<int>(side)];
    motion.lateral = place[1];
    motion.vertical = place[2];
    motion.roll = attitude[0];
    motion.yaw = attitude[2];
    wheel_rail_->Press(motion, side, track_->Rail(side, out.frame.s), track_->support(),
                       &at->wheel[static_cast<int>(side)], &out.wheel[static_cast<int>(side)]);
  }
}

void Binding::MoveWheelset(const mjModel* m, const mjData* d, int index, const double* speed,
                           PressedWheelset* at, rail::WheelDamping* damping) const noexcept {
  const WheelsetBinding& w = wheelsets_[index];
  WheelsetState& out = at->state;
  const BodyVelocity world = VelocityOf(m, d, w.body, w.dofs, speed);
  const Vec3 velocity = ToTrack(out.frame, world.centre);
  const Vec3 rotation = ToTrack(out.frame, world.rotation);
  out.speed = velocity[0];
  out.spin = speed[w.spin_dof];
  Vec3 force_T{};
  out.moment_T = {};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const int k = static_cast<int>(side);
    rail::WheelsetMotion& motion = at->motion[k];
    motion.velocity = rail::MirrorPolar(velocity, side);
    motion.rotation = rail::MirrorAxial(rotation, side);
    motion.speed = std::abs(out.speed);
    rail::WheelRailForces* wheel = &out.wheel[k];
    wheel_rail_->CalcForces(motion, at->wheel[k], wheel, damping == nullptr ? nullptr : damping + k,
                            &at->memo[k]);
    Add(&force_T, rail::MirrorPolar(wheel->force, side));
    Add(&out.moment_T, rail::MirrorAxial(wheel->moment, side));
  }
  out.force = ToWorld(out.frame, force_T);
  out.moment = ToWorld(out.frame, out.moment_T);
}

void Binding::PressWheelsets(mjData* d, Work* work) const noexcept {
  constexpr int kNumbers = (sizeof(PressedWheelset) + sizeof(mjtNum) - 1) / sizeof(mjtNum);
  const int count = static_cast<int>(wheelsets_.size());
  work->wheelsets = reinterpret_cast<PressedWheelset**>(mj_stackAlloc(d, count + 1));
  KeptWheelsets* kept = KeptWheelsets::Of(*this, d);
  for (int i = 0; i < count; ++i) {
    void* room =
        kept != nullptr ? kept->Take(d, i) : static_cast<void*>(mj_stackAlloc(d, kNumbers));
    work->wheelsets[i] = new (room) PressedWheelset;
    PressWheelset(d, i, work->wheelsets[i]);
  }
}

Vec3 Binding::CentreOfMassVelocity(const mjModel* m, const mjData* d, int body) const {
  const BodyVelocity at = VelocityOf(m, d, body, DofChain(m, body), Speed(d));
  const mjtNum* frame = d->xpos + 3 * body;
  const mjtNum* centre = d->xipos + 3 * body;
  Vec3 velocity = at.centre;
  Add(&velocity,
      Cross(at.rotation, {centre[0] - frame[0], centre[1] - frame[1], centre[2] - frame[2]}));
  return velocity;
}

WheelsetState Binding::CalcWheelset(const mjModel* m, const mjData* d, int index) const noexcept {
  const KeptWheelsets* kept = KeptWheelsets::Of(*this, d);
  const PressedWheelset* found = kept != nullptr ? kept->Find(d, index) : nullptr;
  PressedWheelset at;
  if (found != nullptr) {
    at.TakePlace(*found);
  } else {
    PressWheelset(d, index, &at);
  }
  MoveWheelset(m, d, index, Speed(d), &at, nullptr);
  return at.state;
}

void Binding::AddWheelsetForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                                Work* work) const noexcept {
  mjtNum* user = d->userdata;
  for (size_t i = 0; i < wheelsets_.size(); ++i) {
    const WheelsetBinding& w = wheelsets_[i];
    PressedWheelset& at = *work->wheelsets[i];
    rail::WheelDamping damping[2];
    MoveWheelset(m, d, static_cast<int>(i), speed, &at, slopes ? damping : nullptr);
    const WheelsetState& state = at.state;
    const Vec3 com = Load(d->subtree_com + 3 * m->body_rootid[w.body]);
    const Vec3 arm = {state.centre[0] - com[0], state.centre[1] - com[1], state.centre[2] - com[2]};
    Vec3 moment = state.moment;
    Add(&moment, Cross(arm, state.force));
    AddWrench(d, w.dofs, state.force, moment, work->force);
    for (const rail::WheelRailForces& wheel : state.wheel) {
      user[UserData::kCreepPower] += wheel.creep_power;
      user[UserData::kContactPower] += wheel.damping_power;
      user[UserData::kContactEnergy] += wheel.stored_energy;
      user[UserData::kLifted] += wheel.count == 0 ? 1 : 0;
      user[UserData::kBeyondProfile] += wheel.beyond_profile ? 1 : 0;
    }
    user[UserData::kMaxLateral] = std::max(user[UserData::kMaxLateral], std::abs(state.lateral));
    if (!slopes) continue;
    SpatialMatrix sum{};
    for (const Side side : {Side::kLeft, Side::kRight}) {
      AddDampers(damping[static_cast<int>(side)], side, state.frame, arm, work->half, &sum);
    }
    work->matrix->AddSpatial(sum, d->cdof, w.dofs.data(), static_cast<int>(w.dofs.size()));
  }
}

}  // namespace phs::plugin
