// The part of Binding that presses wheelsets on the track. No allocation, no locks, no exceptions.
#include <algorithm>
#include <cmath>
#include <new>

#include "base/wide.h"
#include "plugin/binding_work.h"
#include "plugin/kept_wheelsets.h"

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

/// Adds `scale` times the dampers of a wheel, about the point from which `arm` leads to the
/// wheelset's centre; world axes.
PHS_WIDE void AddDampers(const rail::WheelDamping& dampers, Side side,
                         const rail::TrackFrame& frame, const Vec3& arm, double scale,
                         SpatialMatrix* sum) {
  for (int k = 0; k < dampers.count; ++k) {
    const auto& damper = dampers.damper[static_cast<size_t>(k)];
    const Vec3 force = ToWorld(frame, rail::MirrorPolar(damper.force, side));
    Vec3 turn = ToWorld(frame, rail::MirrorAxial(damper.moment, side));
    Add(&turn, Cross(arm, force));
    const std::array<double, 6> g = {turn[0], turn[1], turn[2], force[0], force[1], force[2]};
    for (size_t i = 0; i < 6; ++i) {
      const double scaled = scale * damper.coefficient * g[i];
      for (size_t j = 0; j < 6; ++j) (*sum)[i][j] += scaled * g[j];
    }
  }
}

}  // namespace

BodyVelocity VelocityOf(const mjModel* m, const mjData* d, int body, const std::vector<int>& dofs,
                        const double* speed) {
  double v[6] = {};
  for (const int dof : dofs) {
    const mjtNum* c = d->cdof + 6 * dof;
    for (int k = 0; k < 6; ++k) v[k] += c[k] * speed[dof];
  }
  const mjtNum* centre = d->xpos + 3 * body;
  const mjtNum* com = d->subtree_com + 3 * m->body_rootid[body];
  BodyVelocity out{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  Add(&out.centre,
      Cross(out.rotation, {centre[0] - com[0], centre[1] - com[1], centre[2] - com[2]}));
  return out;
}

void AddWrench(const mjData* d, const std::vector<int>& dofs, const Vec3& force, const Vec3& moment,
               double* out) {
  for (const int dof : dofs) {
    const mjtNum* c = d->cdof + 6 * dof;
    out[dof] += c[0] * moment[0] + c[1] * moment[1] + c[2] * moment[2] + c[3] * force[0] +
                c[4] * force[1] + c[5] * force[2];
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
