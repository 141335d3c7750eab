// The part of Binding that runs inside MuJoCo's step: wheelsets and the half step. No allocation,
// no locks, no exceptions.
#include <algorithm>
#include <cmath>
#include <new>

#include "plugin/binding.h"
#include "plugin/half_step.h"
#include "plugin/tendon_forces.h"

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

/// Velocity of a point of a body in world axes at speeds `speed` of the dofs of its chain. MuJoCo
/// keeps the axes of dofs at the centre of mass of the whole tree.
struct BodyVelocity {
  Vec3 rotation{};
  Vec3 centre{};
};
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

/// Velocity of a body's frame as MuJoCo left it.
Vec3 CentreVelocity(const mjModel* m, const mjData* d, int body) {
  const mjtNum* centre = d->xpos + 3 * body;
  const mjtNum* com = d->subtree_com + 3 * m->body_rootid[body];
  Vec3 velocity = Load(d->cvel + 6 * body + 3);
  Add(&velocity, Cross(Load(d->cvel + 6 * body),
                       {centre[0] - com[0], centre[1] - com[1], centre[2] - com[2]}));
  return velocity;
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

/// Adds the generalised force of a wrench on a body: force and moment about the centre of mass of
/// the tree, where MuJoCo keeps the axes of dofs.
void AddWrench(const mjData* d, const std::vector<int>& dofs, const Vec3& force, const Vec3& moment,
               double* out) {
  for (const int dof : dofs) {
    const mjtNum* c = d->cdof + 6 * dof;
    out[dof] += c[0] * moment[0] + c[1] * moment[1] + c[2] * moment[2] + c[3] * force[0] +
                c[4] * force[1] + c[5] * force[2];
  }
}

constexpr int kMaxChain = 64;  ///< dofs of a wheelset and its ancestors
/// Slope, force and speed before, of each cylinder.
constexpr int kCylinderNumbers = 3 * kMaxCylinders;

}  // namespace

/// A wheelset where it stands, ready for its forces at any speed.
struct Binding::PressedWheelset {
  WheelsetState state;
  rail::WheelsetMotion motion[2];
  rail::PressedWheel wheel[2];
};

/// Numbers of one evaluation, on MuJoCo's stack.
struct Binding::Work {
  PressedWheelset* wheelsets = nullptr;
  double* force = nullptr;     ///< of wheels, train, brakes, cylinders [nv]
  double* cylinder = nullptr;  ///< the part of the cylinders, which MuJoCo adds itself [nv]
  double* rest = nullptr;      ///< all other forces, at v_n [nv]
  double* drive = nullptr;     ///< the part of actuators that are no cylinders [nv]
  double* row = nullptr;       ///< scratch [nv]
  double* contact = nullptr;   ///< M + h/2 (C of all but cylinders) [nM]
  double* entries = nullptr;   ///< the same with cylinders, factorised [nM]
  double half = 0;             ///< h/2 [s]
  StepMatrix* matrix = nullptr;
  double* slope = nullptr;  ///< kCylinderNumbers of each PHS
};

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
    wheel_rail_->CalcForces(motion, at->wheel[k], wheel,
                            damping == nullptr ? nullptr : damping + k);
    Add(&force_T, rail::MirrorPolar(wheel->force, side));
    Add(&out.moment_T, rail::MirrorAxial(wheel->moment, side));
  }
  out.force = ToWorld(out.frame, force_T);
  out.moment = ToWorld(out.frame, out.moment_T);
}

WheelsetState Binding::CalcWheelset(const mjModel* m, const mjData* d, int index) const noexcept {
  PressedWheelset at;
  PressWheelset(d, index, &at);
  MoveWheelset(m, d, index, Speed(d), &at, nullptr);
  return at.state;
}

void Binding::AddWheelsetForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                                Work* work) const noexcept {
  mjtNum* user = d->userdata;
  for (size_t i = 0; i < wheelsets_.size(); ++i) {
    const WheelsetBinding& w = wheelsets_[i];
    PressedWheelset& at = work->wheelsets[i];
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
    const int count = static_cast<int>(w.dofs.size());
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const rail::WheelDamping& dampers = damping[static_cast<int>(side)];
      for (int k = 0; k < dampers.count; ++k) {
        const auto& damper = dampers.damper[static_cast<size_t>(k)];
        const Vec3 force = ToWorld(state.frame, rail::MirrorPolar(damper.force, side));
        Vec3 turn = ToWorld(state.frame, rail::MirrorAxial(damper.moment, side));
        Add(&turn, Cross(arm, force));
        double row[kMaxChain];
        for (int q = 0; q < count; ++q) {
          const mjtNum* c = d->cdof + 6 * w.dofs[static_cast<size_t>(q)];
          row[q] = c[0] * turn[0] + c[1] * turn[1] + c[2] * turn[2] + c[3] * force[0] +
                   c[4] * force[1] + c[5] * force[2];
        }
        work->matrix->AddOuter(work->half * damper.coefficient, row, w.dofs.data(), count);
      }
    }
  }
}

void Binding::AddRunningForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                               Work* work) const noexcept {
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
    const double spin = speed[w.spin_dof];
    const double most = 2 * share * running_.block_friction * running_.block_force_N * radius;
    const double sign = std::tanh(spin * radius / kRoundingSpeed);
    work->force[w.spin_dof] -= most * sign;
    d->userdata[UserData::kBrakePower] += most * sign * spin;
    moment -= most * sign;
    if (slopes) {
      work->matrix->AddDiagonal(w.spin_dof,
                                work->half * most * radius / kRoundingSpeed * (1 - sign * sign));
    }
  }
  const double along = Dot(forward, VelocityOf(m, d, body, coupler_dofs_, speed).centre);
  const double gain = m->body_subtreemass[root_body_] / kCouplerTime;
  const double force = gain * (target_speed_ - along) - moment / radius;
  const mjtNum* place = d->site_xpos + 3 * coupler_site_;
  const Vec3 com = Load(d->subtree_com + 3 * m->body_rootid[body]);
  const Vec3 arm = {place[0] - com[0], place[1] - com[1], place[2] - com[2]};
  const Vec3 pull = {force * forward[0], force * forward[1], force * forward[2]};
  AddWrench(d, coupler_dofs_, pull, Cross(arm, pull), work->force);
  d->userdata[UserData::kTrainPower] = force * along;
}

void Binding::AddCylinderForces(const mjModel* m, mjData* d, const double* speed,
                                Work* work) const noexcept {
  mjtNum* user = d->userdata;
  std::fill(work->cylinder, work->cylinder + m->nv, 0.0);
  double* slope = work->slope;
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], force[kMaxCylinders];
    double scratch[5][kMaxCylinders], pressure[kMaxLines];
    const int num_cylinders = p.system->num_cylinders();
    mjtNum* v = user + p.speeds_at;
    for (int i = 0; i < num_cylinders; ++i) {
      x[i] = d->actuator_length[p.cylinder[i]] - p.length0[i];
      v[i] = mju_dot(d->actuator_moment + p.cylinder[i] * m->nv, speed, m->nv);
    }
    hydraulics::PhsOutputs out{force,      scratch[0], scratch[1], scratch[2],
                               scratch[3], scratch[4], slope,      pressure};
    p.system->Calc(d->time, x, v, user + p.states_at, &out);
    // MuJoCo's actuator force pushes the ends apart, ours pulls them together.
    for (int i = 0; i < num_cylinders; ++i) {
      user[p.forces_at + i] = -force[i];
      mju_addToScl(work->cylinder, d->actuator_moment + p.cylinder[i] * m->nv, -force[i], m->nv);
    }
    user[UserData::kPhsPower] += out.lost_power;
    user[UserData::kPhsEnergy] += out.stored_energy;
    slope += kCylinderNumbers;
  }
}

void Binding::AddCylinderSlopes(const mjModel* m, const mjData* d, bool secant,
                                Work* work) const noexcept {
  double* numbers = work->slope;
  for (const PhsBinding& p : phs_) {
    double* force_before = numbers + kMaxCylinders;
    double* speed_before = force_before + kMaxCylinders;
    for (int i = 0; i < static_cast<int>(p.cylinder.size()); ++i) {
      const double force = -d->userdata[p.forces_at + i];
      const double speed = d->userdata[p.speeds_at + i];
      double slope = numbers[i];
      if (secant && speed != speed_before[i]) {
        slope = std::max(0.0, (force - force_before[i]) / (speed - speed_before[i]));
      }
      force_before[i] = force;
      speed_before[i] = speed;
      if (!(slope > 0)) continue;
      work->matrix->AddOuter(work->half * slope, d->actuator_moment + p.cylinder[i] * m->nv);
    }
    numbers += kCylinderNumbers;
  }
}

void Binding::CalcForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                         Work* work) const noexcept {
  std::fill(d->userdata, d->userdata + UserData::kHeader, 0.0);
  std::fill(work->force, work->force + m->nv, 0.0);
  if (has_rail()) AddWheelsetForces(m, d, speed, slopes, work);
  if (coupler_site_ >= 0) AddRunningForces(m, d, speed, slopes, work);
  AddCylinderForces(m, d, speed, work);
}

double Binding::DriveControl(const mjModel* m, const mjData* d,
                             const WheelsetBinding& w) const noexcept {
  if (running_.active) return running_.Share(d->time) * running_.drive_torque_Nm;
  // Each axle holds its own speed: torque and speed at the same place damp every mode, while the
  // speed of the frame, felt through the springs of the axle guidance, would drive the bogie to
  // longitudinal oscillation against its wheelsets.
  const mjtNum* r = d->xmat + 9 * root_body_;
  const Vec3 forward = {r[0], r[3], r[6]};
  return speed_gain_ * (target_speed_ - Dot(forward, CentreVelocity(m, d, w.body)));
}

void Binding::AddDrives(const mjModel* m, mjData* d, Work* work) const noexcept {
  const bool driving = has_rail() && target_speed_ > 0 && root_body_ >= 0;
  for (int id = 0; id < m->nu; ++id) {
    if (owner_[id] != nullptr) continue;
    double ctrl = d->ctrl[id];
    for (const WheelsetBinding& w : wheelsets_) {
      if (driving && w.drive_actuator == id) ctrl = DriveControl(m, d, w);
    }
    const double force = ActuatorForce(m, d, id, ctrl);
    mju_addToScl(work->drive, d->actuator_moment + id * m->nv, force, m->nv);
  }
}

void Binding::HalfStep(const mjModel* m, mjData* d, Work* work) const noexcept {
  const int nv = m->nv;
  double* speed = d->userdata + UserData::kHeader;
  double* a = mj_stackAlloc(d, nv);
  double* r = mj_stackAlloc(d, nv);
  std::fill(a, a + nv, 0.0);
  CalcRest(m, d, work);
  work->matrix->SetMass(d);
  AddDamperSlopes(m, d, work->half, work->row, work->matrix);
  for (int round = 0; round < 2; ++round) {
    CalcForces(m, d, speed, round == 0, work);
    // The contacts' slopes serve both rounds.
    if (round == 0) std::copy(work->entries, work->entries + m->nM, work->contact);
    if (round == 1) std::copy(work->contact, work->contact + m->nM, work->entries);
    AddCylinderSlopes(m, d, round == 1, work);
    mj_mulM(m, d, r, a);
    for (int i = 0; i < nv; ++i) {
      r[i] = work->rest[i] + work->force[i] + work->cylinder[i] - r[i];
      work->row[i] = speed[i] - d->qvel[i];
    }
    AddDampers(m, d, work->row, r);
    if (!work->matrix->Factor()) break;
    work->matrix->Solve(r);
    for (int i = 0; i < nv; ++i) {
      a[i] += r[i];
      speed[i] = d->qvel[i] + work->half * a[i];
    }
  }
  CalcForces(m, d, speed, false, work);
  // What MuJoCo must add to the forces it knows, so that its step makes this a.
  mj_mulM(m, d, r, a);
  for (int i = 0; i < nv; ++i) {
    const double smooth = r[i] + 2 * work->half * m->dof_damping[i] * a[i];
    d->qfrc_passive[i] += smooth - work->rest[i] - work->cylinder[i];
  }
}

void Binding::CalcRest(const mjModel* m, mjData* d, Work* work) const noexcept {
  mj_rne(m, d, 0, work->rest);
  for (int i = 0; i < m->nv; ++i) {
    work->rest[i] = d->qfrc_passive[i] - work->rest[i] + work->drive[i];
  }
  AddApplied(m, d, work->rest);
}

void Binding::CalcRates(mjData* d, double h) const noexcept {
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], mean[kMaxCylinders];
    for (int i = 0; i < p.system->num_cylinders(); ++i) {
      x[i] = d->actuator_length[p.cylinder[i]] - p.length0[i];
      // The speed of the whole step, v + h a = 2 w - v.
      mean[i] = 2 * d->userdata[p.speeds_at + i] - d->actuator_velocity[p.cylinder[i]];
    }
    p.system->CalcStateRate(d->time, h, x, mean, d->userdata + p.states_at,
                            d->userdata + p.rates_at);
  }
}

void Binding::AdvanceStates(const mjModel* m, mjData* d, double h) const noexcept {
  mjtNum* act = d->act - (m->nu - m->na);
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], mean[kMaxCylinders], state[kMaxStates], rate[kMaxStates];
    for (int i = 0; i < p.system->num_cylinders(); ++i) {
      x[i] = d->actuator_length[p.cylinder[i]] - p.length0[i];
      mean[i] = mju_dot(d->actuator_moment + p.cylinder[i] * m->nv, d->qvel, m->nv);
    }
    const int num_states = p.system->num_states();
    for (int i = 0; i < num_states; ++i) state[i] = act[p.state_actuator[i]];
    p.system->CalcStateRate(d->time, h, x, mean, state, rate);
    for (int i = 0; i < num_states; ++i) act[p.state_actuator[i]] += h * rate[i];
  }
}

void Binding::BookPowers(const mjModel* m, mjData* d, Work* work) const noexcept {
  const double* speed = Speed(d);
  std::fill(work->row, work->row + m->nv, 0.0);
  AddDampers(m, d, speed, work->row);
  d->userdata[UserData::kDamperPower] = -mju_dot(work->row, speed, m->nv);
  d->userdata[UserData::kDrivePower] = mju_dot(work->drive, speed, m->nv);
}

void Binding::Passive(const mjModel* m, mjData* d) const noexcept {
  mjMARKSTACK;
  Work work;
  work.force = mj_stackAlloc(d, m->nv);
  work.cylinder = mj_stackAlloc(d, m->nv);
  work.rest = mj_stackAlloc(d, m->nv);
  work.drive = mj_stackAlloc(d, m->nv);
  work.row = mj_stackAlloc(d, m->nv);
  work.slope = mj_stackAlloc(d, kCylinderNumbers * static_cast<int>(phs_.size()) + 1);
  work.contact = mj_stackAlloc(d, m->nM);
  work.entries = mj_stackAlloc(d, m->nM);
  StepMatrix matrix(m, work.entries);
  work.matrix = &matrix;
  constexpr int kNumbers = (sizeof(PressedWheelset) + sizeof(mjtNum) - 1) / sizeof(mjtNum);
  const int num_wheelsets = static_cast<int>(wheelsets_.size());
  mjtNum* room = mj_stackAlloc(d, kNumbers * num_wheelsets + 1);
  work.wheelsets = reinterpret_cast<PressedWheelset*>(room);
  for (int i = 0; i < num_wheelsets; ++i) {
    PressWheelset(d, i, new (room + kNumbers * i) PressedWheelset);
  }
  std::copy(d->qvel, d->qvel + m->nv, d->userdata + UserData::kHeader);
  for (const PhsBinding& p : phs_) {
    for (size_t i = 0; i < p.state_actuator.size(); ++i) {
      d->userdata[p.states_at + static_cast<int>(i)] =
          d->act[p.state_actuator[i] - (m->nu - m->na)];
    }
  }
  std::fill(work.drive, work.drive + m->nv, 0.0);
  AddDrives(m, d, &work);
  const bool instant = m->opt.integrator == mjINT_RK4;
  work.half = instant ? 0 : 0.5 * m->opt.timestep;
  if (instant) {
    CalcForces(m, d, Speed(d), false, &work);
    mju_addTo(d->qfrc_passive, work.force, m->nv);
  } else {
    HalfStep(m, d, &work);
  }
  CalcRates(d, 2 * work.half);
  BookPowers(m, d, &work);
  mjFREESTACK;
}

void Binding::Control(const mjModel* m, mjData* d) const noexcept {
  if (!has_rail() || target_speed_ <= 0 || root_body_ < 0) return;
  for (const WheelsetBinding& w : wheelsets_) {
    if (w.drive_actuator >= 0) d->ctrl[w.drive_actuator] = DriveControl(m, d, w);
  }
}

double Binding::ActDyn(const mjModel*, const mjData* d, int actuator) const noexcept {
  return rate_at_[actuator] < 0 ? 0.0 : d->userdata[rate_at_[actuator]];
}

double Binding::Bias(const mjData* d, int actuator) const noexcept {
  return cylinder_at_[actuator] < 0 ? 0.0 : d->userdata[cylinder_at_[actuator]];
}

}  // namespace phs::plugin
