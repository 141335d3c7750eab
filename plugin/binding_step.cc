// The part of Binding that runs inside MuJoCo's step: the half step, drives, train, elements. No
// allocation, no locks, no exceptions.
#include <algorithm>
#include <cmath>
#include <new>

#include "plugin/active_steering.h"
#include "plugin/bias.h"
#include "plugin/binding_work.h"
#include "plugin/guest.h"

namespace phs::plugin {
namespace {

using rail::Vec3;

constexpr double kCouplerTime = 0.5;  ///< time constant of the speed that the train holds [s]

/// Velocity of a body's frame as MuJoCo left it.
Vec3 CentreVelocity(const mjModel* m, const mjData* d, int body) {
  const mjtNum* centre = d->xpos + 3 * body;
  const mjtNum* com = d->subtree_com + 3 * m->body_rootid[body];
  Vec3 velocity = Load(d->cvel + 6 * body + 3);
  Add(&velocity, Cross(Load(d->cvel + 6 * body),
                       {centre[0] - com[0], centre[1] - com[1], centre[2] - com[2]}));
  return velocity;
}

}  // namespace

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
  const BodyVelocity velocity = VelocityOf(m, d, body, coupler_dofs_, speed);
  const double along = Dot(forward, velocity.centre);
  const double gain = m->body_subtreemass[root_body_] / kCouplerTime;
  const double force = gain * (target_speed_ - along) - moment / radius;
  const mjtNum* place = d->site_xpos + 3 * coupler_site_;
  const Vec3 com = Load(d->subtree_com + 3 * m->body_rootid[body]);
  const Vec3 arm = {place[0] - com[0], place[1] - com[1], place[2] - com[2]};
  const Vec3 pull = {force * forward[0], force * forward[1], force * forward[2]};
  AddWrench(d, coupler_dofs_, pull, Cross(arm, pull), work->force);
  // The body turns with the track, so that the coupler, beside its centre, moves otherwise.
  const mjtNum* centre = d->xpos + 3 * body;
  const Vec3 beside = {place[0] - centre[0], place[1] - centre[1], place[2] - centre[2]};
  d->userdata[UserData::kTrainPower] =
      force * (along + Dot(forward, Cross(velocity.rotation, beside)));
}

bool Binding::Factor(const mjModel* m, const mjData* d, bool again, Work* work) const noexcept {
  // Slopes of the contacts serve both rounds, those of the cylinders are looked at again.
  bool changed = !again;
  double* numbers = work->slope;
  for (const PhsBinding& p : phs_) {
    double* used = numbers + kMaxCylinders;
    double* force_before = used + kMaxCylinders;
    double* speed_before = force_before + kMaxCylinders;
    for (int i = 0; i < static_cast<int>(p.cylinder.size()); ++i) {
      const double force = -d->userdata[p.forces_at + i];
      const double speed = d->userdata[p.speeds_at + i];
      double slope = again ? used[i] : numbers[i];
      if (again && speed != speed_before[i]) {
        slope = std::max(0.0, (force - force_before[i]) / (speed - speed_before[i]));
      }
      constexpr double kSame = 0.02;
      if (!again || std::abs(slope - used[i]) > kSame * (slope + used[i])) {
        changed = true;
        used[i] = slope;
      }
      force_before[i] = force;
      speed_before[i] = speed;
    }
    numbers += kCylinderNumbers;
  }
  if (!changed) return true;
  if (!again) std::copy(work->entries, work->entries + m->nM, work->contact);
  if (again) std::copy(work->contact, work->contact + m->nM, work->entries);
  numbers = work->slope;
  for (const PhsBinding& p : phs_) {
    for (size_t i = 0; i < p.cylinder.size(); ++i) {
      const double slope = numbers[kMaxCylinders + i];
      if (!(slope > 0)) continue;
      work->matrix->AddOuter(work->half * slope, d->actuator_moment + p.cylinder[i] * m->nv);
    }
    numbers += kCylinderNumbers;
  }
  return work->matrix->Factor();
}

void Binding::AddElementForces(const mjModel* m, const mjData* d, const double* speed,
                               Work* work) const noexcept {
  for (const auto& elements : elements_) {
    if (elements->InEngine()) continue;
    elements->AddSprings(m, d, work->force);
    elements->AddDampers(m, d, speed, work->force);
  }
}

void Binding::AddEngineDampers(const mjModel* m, const mjData* d, const double* speed,
                               double* force) const noexcept {
  for (const auto& elements : elements_) {
    if (elements->InEngine()) elements->AddDampers(m, d, speed, force);
  }
}

void Binding::CalcForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                         Work* work) const noexcept {
  std::fill(d->userdata, d->userdata + UserData::kHeader, 0.0);
  d->userdata[UserData::kTime] = d->time;
  std::fill(work->force, work->force + m->nv, 0.0);
  if (has_rail()) AddWheelsetForces(m, d, speed, slopes, work);
  if (coupler_site_ >= 0) AddRunningForces(m, d, speed, slopes, work);
  if (Drives() && !running_.active) AddSpeedHold(m, d, speed, work);
  AddElementForces(m, d, speed, work);
  AddCylinderForces(m, d, speed, slopes, work);
}

double Binding::DriveControl(const mjModel* m, const mjData* d,
                             const WheelsetBinding& w) const noexcept {
  if (Guest::Has(d, w.drive_actuator)) return d->ctrl[w.drive_actuator];
  if (running_.active) return running_.Share(d->time) * running_.drive_torque_Nm;
  return HeldTorque(d, CentreVelocity(m, d, w.body));
}

// Each axle holds its own speed: torque and speed at the same place damp every mode, while the
// speed of the frame, felt through the springs of the axle guidance, would drive the bogie to
// longitudinal oscillation against its wheelsets.
double Binding::HeldTorque(const mjData* d, const Vec3& velocity) const noexcept {
  const mjtNum* r = d->xmat + 9 * root_body_;
  return speed_gain_ * (target_speed_ - Dot({r[0], r[3], r[6]}, velocity));
}

void Binding::AddSpeedHold(const mjModel* m, mjData* d, const double* speed,
                           Work* work) const noexcept {
  for (const WheelsetBinding& w : wheelsets_) {
    const int id = w.drive_actuator;
    if (id < 0 || Guest::Has(d, id)) continue;
    const double held = HeldTorque(d, VelocityOf(m, d, w.body, w.dofs, speed).centre);
    const double more =
        ActuatorForce(m, d, id, held) - ActuatorForce(m, d, id, DriveControl(m, d, w));
    const mjtNum* moment = d->actuator_moment + id * m->nv;
    mju_addToScl(work->force, moment, more, m->nv);
    d->userdata[UserData::kHoldMore] += more;
    d->userdata[UserData::kDrivePower] += more * mju_dot(moment, speed, m->nv);
  }
}

void Binding::AddDrives(const mjModel* m, mjData* d, Work* work) const noexcept {
  for (int id = 0; id < m->nu; ++id) {
    if (owner_[id] != nullptr) continue;
    double ctrl = d->ctrl[id];
    for (const WheelsetBinding& w : wheelsets_) {
      if (Drives() && w.drive_actuator == id) ctrl = DriveControl(m, d, w);
    }
    const double force = ActuatorForce(m, d, id, ctrl);
    if (force == 0) continue;
    mju_addToScl(work->drive, d->actuator_moment + id * m->nv, force, m->nv);
  }
}

void Binding::HalfStep(const mjModel* m, mjData* d, Work* work) const noexcept {
  const int nv = m->nv;
  double* speed = d->userdata + UserData::kHeader;
  double* a = mj_stackAlloc(d, nv);
  double* r = mj_stackAlloc(d, nv);
  double* bias = mj_stackAlloc(d, nv);
  double* bias_before = mj_stackAlloc(d, nv);
  std::fill(a, a + nv, 0.0);
  std::fill(r, r + nv, 0.0);
  CalcRest(m, d, work);
  CalcBiasAt(m, d, d->qvel, bias_before);
  std::copy(bias_before, bias_before + nv, bias);
  work->matrix->SetMass(d);
  for (const auto& elements : elements_) {
    elements->AddSlopes(m, d, speed, work->half, work->row, work->matrix);
  }
  for (int round = 0; round < 2; ++round) {
    CalcForces(m, d, speed, round == 0, work);
    if (round == 1) {
      CalcBiasAt(m, d, speed, bias);
      work->matrix->MulMass(d, a, r);
    }
    for (int i = 0; i < nv; ++i) {
      r[i] = work->rest[i] + work->force[i] + work->cylinder[i] - bias[i] - r[i];
      work->row[i] = speed[i] - d->qvel[i];
    }
    AddEngineDampers(m, d, work->row, r);
    if (!Factor(m, d, round == 1, work)) break;
    work->matrix->Solve(r);
    for (int i = 0; i < nv; ++i) {
      a[i] += r[i];
      speed[i] = d->qvel[i] + work->half * a[i];
    }
  }
  FollowCylinders(m, d, speed, work);
  // What MuJoCo must add to the forces it knows, so that its step makes this a.
  work->matrix->MulMass(d, a, r);
  for (int i = 0; i < nv; ++i) {
    const double smooth = r[i] + 2 * work->half * m->dof_damping[i] * a[i];
    d->qfrc_passive[i] += smooth - work->rest[i] - work->cylinder[i] + bias_before[i];
  }
}

void Binding::CalcRest(const mjModel* m, mjData* d, Work* work) const noexcept {
  for (int i = 0; i < m->nv; ++i) work->rest[i] = d->qfrc_passive[i] + work->drive[i];
  AddApplied(m, d, work->rest);
}

void Binding::BookPowers(const mjModel* m, mjData* d, Work* work) const noexcept {
  const double* speed = Speed(d);
  d->userdata[UserData::kDamperPower] = 0;
  for (const auto& elements : elements_) {
    d->userdata[UserData::kDamperPower] += elements->LostPower(m, d, speed);
  }
  d->userdata[UserData::kDrivePower] += mju_dot(work->drive, speed, m->nv);
  std::fill(work->row, work->row + m->nv, 0.0);
  AddApplied(m, d, work->row);
  d->userdata[UserData::kAppliedPower] = mju_dot(work->row, speed, m->nv);
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
  work.entries = mj_stackAlloc(d, m->nM + m->nv);
  StepMatrix matrix(m, ancestors_.data(), work.entries);
  work.matrix = &matrix;
  PressWheelsets(d, &work);
  std::copy(d->qvel, d->qvel + m->nv, d->userdata + UserData::kHeader);
  std::copy(d->qpos, d->qpos + m->nq, d->userdata + UserData::kHeader + m->nv);
  for (const PhsBinding& p : phs_) {
    for (size_t i = 0; i < p.state_actuator.size(); ++i) {
      d->userdata[p.states_at + static_cast<int>(i)] =
          d->act[p.state_actuator[i] - (m->nu - m->na)];
    }
  }
  constexpr int kInstant = (sizeof(hydraulics::Instant) + sizeof(mjtNum) - 1) / sizeof(mjtNum);
  work.instants = reinterpret_cast<hydraulics::Instant*>(
      mj_stackAlloc(d, kInstant * static_cast<int>(phs_.size()) + 1));
  SolveCylinders(d, &work);
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
  CalcRates(d, 2 * work.half, work);
  BookPowers(m, d, &work);
  mjFREESTACK;
}

void Binding::Control(const mjModel* m, mjData* d) const noexcept {
  ControlSteering(m, d);
  if (!Drives()) return;
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
