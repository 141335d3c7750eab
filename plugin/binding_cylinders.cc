// Cylinders inside MuJoCo's step: their forces, slopes and rates of state. No allocation, no locks,
// no exceptions.
#include <algorithm>
#include <new>

#include "plugin/binding_work.h"

namespace phs::plugin {
namespace {

/// Rate of length of a cylinder at `speed` of the dofs.
double SpeedOf(const mjModel* m, const mjData* d, const PhsBinding& p, int cylinder,
               const double* speed) {
  const mjtNum* row = d->actuator_moment + p.cylinder[cylinder] * m->nv;
  double rate = 0;
  for (const int dof : p.dofs[cylinder]) rate += row[dof] * speed[dof];
  return rate;
}

/// Adds the generalised force of a cylinder that pushes its ends apart with `force`.
void AddForceOf(const mjModel* m, const mjData* d, const PhsBinding& p, int cylinder, double force,
                double* out) {
  const mjtNum* row = d->actuator_moment + p.cylinder[cylinder] * m->nv;
  for (const int dof : p.dofs[cylinder]) out[dof] += force * row[dof];
}

/// Extension of each cylinder from rest.
void Displacements(const mjData* d, const PhsBinding& p, double* x) {
  for (size_t i = 0; i < p.cylinder.size(); ++i) {
    x[i] = d->actuator_length[p.cylinder[i]] - p.length0[i];
  }
}

}  // namespace

void Binding::SolveCylinders(const mjData* d, Work* work) const noexcept {
  double x[kMaxCylinders];
  for (size_t k = 0; k < phs_.size(); ++k) {
    const PhsBinding& p = phs_[k];
    Displacements(d, p, x);
    p.system->Solve(d->time, x, d->userdata + p.states_at,
                    new (work->instants + k) hydraulics::Instant);
  }
}

void Binding::AddCylinderForces(const mjModel* m, mjData* d, const double* speed, bool slopes,
                                Work* work) const noexcept {
  mjtNum* user = d->userdata;
  std::fill(work->cylinder, work->cylinder + m->nv, 0.0);
  double* slope = work->slope;
  const hydraulics::Instant* at = work->instants;
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], force[kMaxCylinders];
    const int num_cylinders = p.system->num_cylinders();
    Displacements(d, p, x);
    mjtNum* v = user + p.speeds_at;
    for (int i = 0; i < num_cylinders; ++i) v[i] = SpeedOf(m, d, p, i, speed);
    hydraulics::PhsOutputs out;
    out.force = force;
    out.piston = user + p.pistons_at;
    out.pressure = user + p.pressures_at;
    if (slopes) out.damping = slope;  // the second round has a secant
    out.energy = !slopes;             // of the last round alone
    out.stored = (m->opt.enableflags & mjENBL_ENERGY) != 0;
    p.system->CalcAt(*at++, x, v, user + p.states_at, &out);
    // MuJoCo's actuator force pushes the ends apart, ours pulls them together.
    for (int i = 0; i < num_cylinders; ++i) {
      user[p.forces_at + i] = -force[i];
      AddForceOf(m, d, p, i, -force[i], work->cylinder);
    }
    user[UserData::kPhsPower] += out.lost_power;
    user[UserData::kPhsEnergy] += out.stored_energy;
    slope += kCylinderNumbers;
  }
}

void Binding::FollowCylinders(const mjModel* m, mjData* d, const double* speed,
                              Work* work) const noexcept {
  const double* numbers = work->slope;
  for (const PhsBinding& p : phs_) {
    for (int i = 0; i < static_cast<int>(p.cylinder.size()); ++i) {
      const double now = SpeedOf(m, d, p, i, speed);
      const double less = numbers[kMaxCylinders + i] * (now - d->userdata[p.speeds_at + i]);
      d->userdata[p.speeds_at + i] = now;
      d->userdata[p.forces_at + i] -= less;
      AddForceOf(m, d, p, i, -less, work->cylinder);
    }
    numbers += kCylinderNumbers;
  }
}

void Binding::CalcRates(mjData* d, double h, const Work& work) const noexcept {
  const hydraulics::Instant* at = work.instants;
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], mean[kMaxCylinders], before[kMaxCylinders];
    Displacements(d, p, x);
    for (int i = 0; i < p.system->num_cylinders(); ++i) {
      // The speed of the whole step, v + h a = 2 w - v.
      before[i] = d->actuator_velocity[p.cylinder[i]];
      mean[i] = 2 * d->userdata[p.speeds_at + i] - before[i];
    }
    p.system->CalcStateRateAt(*at++, h, x, mean, d->userdata + p.states_at,
                              d->userdata + p.rates_at, before);
  }
}

void Binding::AdvanceStates(const mjModel* m, mjData* d, double h) const noexcept {
  mjtNum* act = d->act - (m->nu - m->na);
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], mean[kMaxCylinders], state[kMaxStates], rate[kMaxStates];
    Displacements(d, p, x);
    for (int i = 0; i < p.system->num_cylinders(); ++i) mean[i] = SpeedOf(m, d, p, i, d->qvel);
    const int num_states = p.system->num_states();
    for (int i = 0; i < num_states; ++i) state[i] = act[p.state_actuator[i]];
    p.system->CalcStateRate(d->time, h, x, mean, state, rate);
    for (int i = 0; i < num_states; ++i) act[p.state_actuator[i]] += h * rate[i];
  }
}

void Binding::SettleChambers(const mjModel* m, mjData* d) const {
  const bool splits = std::any_of(phs_.begin(), phs_.end(),
                                  [](const PhsBinding& p) { return p.system->has_split_lines(); });
  if (!splits) return;
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_tendon(m, d);
  mj_transmission(m, d);
  mjtNum* act = d->act - (m->nu - m->na);
  for (const PhsBinding& p : phs_) {
    double x[kMaxCylinders], state[kMaxStates];
    Displacements(d, p, x);
    const int num_states = p.system->num_states();
    for (int i = 0; i < num_states; ++i) state[i] = act[p.state_actuator[i]];
    p.system->SettleChambers(d->time, x, state);
    for (int i = 0; i < num_states; ++i) act[p.state_actuator[i]] = state[i];
  }
}

}  // namespace phs::plugin
