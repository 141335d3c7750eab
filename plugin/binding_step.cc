// The part of Binding that runs inside MuJoCo's step. No allocation, no locks, no exceptions.
#include <algorithm>
#include <cmath>

#include "plugin/binding.h"

namespace phs::plugin {
namespace {

using rail::Side;
using rail::Vec3;

constexpr double kCouplerTime = 0.5;  ///< time constant of the speed that the train holds [s]

double Dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec3 Cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3 Load(const mjtNum* p) { return {p[0], p[1], p[2]}; }
Vec3 ToTrack(const rail::TrackFrame& f, const Vec3& v) {
  return {Dot(f.forward, v), Dot(f.left, v), Dot(f.up, v)};
}
Vec3 ToWorld(const rail::TrackFrame& f, const Vec3& v) {
  Vec3 w;
  for (int i = 0; i < 3; ++i) w[i] = f.forward[i] * v[0] + f.left[i] * v[1] + f.up[i] * v[2];
  return w;
}
void Add(Vec3* a, const Vec3& b) {
  for (int i = 0; i < 3; ++i) (*a)[i] += b[i];
}

/// Velocity of a body's frame; MuJoCo keeps velocities at the centre of mass of the whole tree.
Vec3 CentreVelocity(const mjModel* m, const mjData* d, int body) {
  const mjtNum* centre = d->xpos + 3 * body;
  const mjtNum* com = d->subtree_com + 3 * m->body_rootid[body];
  Vec3 velocity = Load(d->cvel + 6 * body + 3);
  Add(&velocity, Cross(Load(d->cvel + 6 * body),
                       {centre[0] - com[0], centre[1] - com[1], centre[2] - com[2]}));
  return velocity;
}

/// Position, attitude and speed of a wheelset in T axes (forces still empty).
void PlaceOnTrack(const mjModel* m, const mjData* d, const rail::Track& track, int body,
                  WheelsetState* out, Vec3* velocity_T, Vec3* rotation_T) {
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
  const Vec3 omega = Load(d->cvel + 6 * body);
  const Vec3 velocity = CentreVelocity(m, d, body);
  *velocity_T = ToTrack(out->frame, velocity);
  *rotation_T = ToTrack(out->frame, omega);
  out->speed = (*velocity_T)[0];
}

}  // namespace

WheelsetState Binding::CalcWheelset(const mjModel* m, const mjData* d, int index) const noexcept {
  WheelsetState out;
  Vec3 velocity;
  Vec3 rotation;
  PlaceOnTrack(m, d, *track_, wheelsets_[index].body, &out, &velocity, &rotation);
  Vec3 force_T{};
  Vec3 elastic_force_T{};
  Vec3 elastic_moment_T{};
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Vec3 place = rail::MirrorPolar({0, out.lateral, out.vertical}, side);
    const Vec3 attitude = rail::MirrorAxial({out.roll, 0, out.yaw}, side);
    rail::WheelsetMotion motion;
    motion.lateral = place[1];
    motion.vertical = place[2];
    motion.roll = attitude[0];
    motion.yaw = attitude[2];
    motion.velocity = rail::MirrorPolar(velocity, side);
    motion.rotation = rail::MirrorAxial(rotation, side);
    motion.speed = std::abs(out.speed);
    rail::WheelRailForces* wheel = &out.wheel[static_cast<int>(side)];
    wheel_rail_->Calc(motion, side, track_->Rail(side, out.frame.s), track_->support(), wheel);
    Add(&force_T, rail::MirrorPolar(wheel->force, side));
    Add(&out.moment_T, rail::MirrorAxial(wheel->moment, side));
    Add(&elastic_force_T, rail::MirrorPolar(wheel->elastic_force, side));
    Add(&elastic_moment_T, rail::MirrorAxial(wheel->elastic_moment, side));
  }
  out.force = ToWorld(out.frame, force_T);
  out.moment = ToWorld(out.frame, out.moment_T);
  out.elastic_force = ToWorld(out.frame, elastic_force_T);
  out.elastic_moment = ToWorld(out.frame, elastic_moment_T);
  return out;
}

void Binding::AddWheelsetForces(const mjModel* m, mjData* d) const noexcept {
  mjtNum* user = d->userdata;
  std::fill(user, user + UserData::kHeader, 0.0);
  for (size_t i = 0; i < wheelsets_.size(); ++i) {
    const WheelsetBinding& w = wheelsets_[i];
    const WheelsetState state = CalcWheelset(m, d, static_cast<int>(i));
    // Generalised force = cdof . wrench, both about the centre of mass of the tree.
    const Vec3 com = Load(d->subtree_com + 3 * m->body_rootid[w.body]);
    const Vec3 arm = {state.centre[0] - com[0], state.centre[1] - com[1], state.centre[2] - com[2]};
    Vec3 moment = state.moment;
    Add(&moment, Cross(arm, state.force));
    Vec3 elastic = state.elastic_moment;
    Add(&elastic, Cross(arm, state.elastic_force));
    mjtNum* keep = user + UserData::kHeader + UserData::kPerWheelset * static_cast<int>(i);
    for (size_t k = 0; k < 3; ++k) {
      keep[k] = elastic[k];
      keep[3 + k] = state.elastic_force[k];
    }
    for (const int dof : w.dofs) {
      const mjtNum* c = d->cdof + 6 * dof;
      d->qfrc_passive[dof] += c[0] * moment[0] + c[1] * moment[1] + c[2] * moment[2] +
                              c[3] * state.force[0] + c[4] * state.force[1] + c[5] * state.force[2];
    }
    d->qfrc_passive[w.spin_dof] += w.lent_damping * d->qvel[w.spin_dof];
    for (const rail::WheelRailForces& wheel : state.wheel) {
      user[UserData::kCreepPower] += wheel.creep_power;
      user[UserData::kContactPower] += wheel.damping_power;
      user[UserData::kContactEnergy] += wheel.stored_energy;
      user[UserData::kLifted] += wheel.count == 0 ? 1 : 0;
      user[UserData::kBeyondProfile] += wheel.beyond_profile ? 1 : 0;
    }
    user[UserData::kMaxLateral] = std::max(user[UserData::kMaxLateral], std::abs(state.lateral));
  }
}

void Binding::AddRunningForces(const mjModel* m, mjData* d) const noexcept {
  const double share = running_.Share(d->time);
  const double radius = wheel_rail_->params().wheel_radius;
  const int body = m->site_bodyid[coupler_site_];
  const mjtNum* r = d->xmat + 9 * body;
  const Vec3 forward = {r[0], r[3], r[6]};
  double moment = 0;  // all moments that drive the axles forward
  for (const WheelsetBinding& w : wheelsets_) {
    if (w.drive_actuator >= 0) moment += share * running_.drive_torque_Nm;
    // Both wheels; the sign of friction is rounded off within 0.05 m/s at the tread.
    constexpr double kRoundingSpeed = 0.05;
    const double spin = d->qvel[w.spin_dof];
    const double brake = 2 * share * running_.block_friction * running_.block_force_N * radius *
                         std::tanh(spin * radius / kRoundingSpeed);
    d->qfrc_passive[w.spin_dof] -= brake;
    d->userdata[UserData::kBrakePower] += brake * spin;
    moment -= brake;
  }
  const double speed = Dot(forward, CentreVelocity(m, d, body));
  const double gain = m->body_subtreemass[root_body_] / kCouplerTime;
  const double force = gain * (target_speed_ - speed) - moment / radius;
  const mjtNum* place = d->site_xpos + 3 * coupler_site_;
  const Vec3 com = Load(d->subtree_com + 3 * m->body_rootid[body]);
  const Vec3 arm = {place[0] - com[0], place[1] - com[1], place[2] - com[2]};
  const Vec3 pull = {force * forward[0], force * forward[1], force * forward[2]};
  const Vec3 turn = Cross(arm, pull);
  for (const int dof : coupler_dofs_) {
    const mjtNum* c = d->cdof + 6 * dof;
    d->qfrc_passive[dof] += c[0] * turn[0] + c[1] * turn[1] + c[2] * turn[2] + c[3] * pull[0] +
                            c[4] * pull[1] + c[5] * pull[2];
  }
  d->userdata[UserData::kTrainPower] = force * speed;
}

void Binding::EvaluatePhs(const mjModel* m, mjData* d) const noexcept {
  mjtNum* user = d->userdata;
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], v[kMaxCylinders], state[kMaxStates];
    double force[kMaxCylinders], scratch[5][kMaxCylinders], pressure[kMaxLines];
    const int num_cylinders = p.system->num_cylinders();
    const int num_states = p.system->num_states();
    for (int i = 0; i < num_cylinders; ++i) {
      x[i] = d->actuator_length[p.cylinder[i]] - p.length0[i];
      v[i] = d->actuator_velocity[p.cylinder[i]];
    }
    for (int i = 0; i < num_states; ++i) state[i] = d->act[p.state_actuator[i] - (m->nu - m->na)];
    hydraulics::PhsOutputs out{force,      scratch[0], scratch[1], scratch[2],
                               scratch[3], scratch[4], pressure};
    p.system->Calc(d->time, x, v, state, &out);
    // MuJoCo's actuator force pushes the ends apart, ours pulls them together.
    for (int i = 0; i < num_cylinders; ++i) user[p.forces_at + i] = -force[i];
    const double h = m->opt.integrator == mjINT_RK4 ? 0.0 : m->opt.timestep;
    p.system->CalcStateRate(d->time, h, x, v, state, user + p.rates_at);
    user[UserData::kPhsPower] += out.lost_power;
    user[UserData::kPhsEnergy] += out.stored_energy;
  }
}

void Binding::Passive(const mjModel* m, mjData* d) const noexcept {
  if (has_rail()) AddWheelsetForces(m, d);
  if (coupler_site_ >= 0) AddRunningForces(m, d);
  EvaluatePhs(m, d);
}

void Binding::Control(const mjModel* m, mjData* d) const noexcept {
  if (!has_rail() || target_speed_ <= 0 || root_body_ < 0) return;
  if (running_.active) {
    const double torque = running_.Share(d->time) * running_.drive_torque_Nm;
    for (const WheelsetBinding& w : wheelsets_) {
      if (w.drive_actuator >= 0) d->ctrl[w.drive_actuator] = torque;
    }
    return;
  }
  // Each axle holds its own speed: torque and speed at the same place damp every mode, while the
  // speed of the frame, felt through the springs of the axle guidance, would drive the bogie to
  // longitudinal oscillation against its wheelsets.
  const mjtNum* r = d->xmat + 9 * root_body_;
  const Vec3 forward = {r[0], r[3], r[6]};
  for (const WheelsetBinding& w : wheelsets_) {
    if (w.drive_actuator < 0) continue;
    const double speed = Dot(forward, CentreVelocity(m, d, w.body));
    d->ctrl[w.drive_actuator] = speed_gain_ * (target_speed_ - speed);
  }
}

double Binding::ActDyn(const mjModel*, const mjData* d, int actuator) const noexcept {
  return rate_at_[actuator] < 0 ? 0.0 : d->userdata[rate_at_[actuator]];
}

double Binding::Bias(const mjData* d, int actuator) const noexcept {
  return cylinder_at_[actuator] < 0 ? 0.0 : d->userdata[cylinder_at_[actuator]];
}

}  // namespace phs::plugin
