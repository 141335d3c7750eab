#include "vehicle/energy_book.h"

#include <algorithm>
#include <cmath>

#include "plugin/tendon_forces.h"

namespace phs::vehicle {

using plugin::UserData;

double EnergyBook::Error() const {
  return work_in - (kinetic - start_kinetic) - stored - lost_creep - lost_contact - lost_dampers -
         lost_phs - lost_brakes - lent;
}

double EnergyBook::RelativeError() const {
  const double lost = lost_creep + lost_contact + lost_dampers + lost_phs + lost_brakes;
  const double scale =
      std::max({std::abs(work_in), train, std::abs(lost), std::abs(kinetic - start_kinetic)});
  return scale > 0 ? Error() / scale : 0;
}

EnergyKeeper::EnergyKeeper(const mjModel* m, const plugin::Binding& binding)
    : binding_(binding),
      damping_(m->dof_damping, m->dof_damping + m->nv),
      speed_(static_cast<size_t>(m->nv)),
      spring_(static_cast<size_t>(m->nv)),
      link_damper_(static_cast<size_t>(m->nv)) {
  for (const auto& w : binding.wheelsets()) damping_[w.spin_dof] -= w.lent_damping;
}

void EnergyKeeper::Before(const mjModel* m, const mjData* d) {
  std::copy(d->qvel, d->qvel + m->nv, speed_.begin());
  for (int j = 0; j < m->njnt; ++j) {
    if (m->jnt_type[j] != mjJNT_SLIDE && m->jnt_type[j] != mjJNT_HINGE) continue;
    const int q = m->jnt_qposadr[j];
    spring_[m->jnt_dofadr[j]] = -m->jnt_stiffness[j] * (d->qpos[q] - m->qpos_spring[q]);
  }
}

void EnergyKeeper::ReadLinkages(const mjModel* m, const mjData* d) {
  std::fill(link_damper_.begin(), link_damper_.end(), 0.0);
  plugin::ForEachTendonDof(m, d, [&](int t, int dof, double moment) {
    spring_[dof] += moment * plugin::TendonSpringForce(m, d, t);
    link_damper_[dof] -= moment * m->tendon_damping[t] * d->ten_velocity[t];
  });
}

void EnergyKeeper::Read(const mjData* d) {
  const double stored =
      d->energy[0] + d->userdata[UserData::kContactEnergy] + d->userdata[UserData::kPhsEnergy];
  if (!has_start_) {
    start_stored_ = stored;
    book_.start_kinetic = d->energy[1];
    has_start_ = true;
  }
  book_.kinetic = d->energy[1];
  book_.stored = stored - start_stored_;
}

void EnergyKeeper::After(const mjModel* m, const mjData* d) {
  const double h = m->opt.timestep;
  ReadLinkages(m, d);
  double contact = 0;  // Q . (v1 - v0)/2
  double phs = 0;
  for (int i = 0; i < m->nv; ++i) {
    const double change = 0.5 * (d->qvel[i] - speed_[i]);
    const double mean = speed_[i] + change;
    contact +=
        change * (d->qfrc_passive[i] - spring_[i] - link_damper_[i] + damping_[i] * speed_[i]);
    phs += change * d->qfrc_actuator[i];
    book_.lost_dampers += h * (damping_[i] * d->qvel[i] - link_damper_[i]) * mean;
  }
  // Elastic contact forces lose nothing: what they store is read from the contacts themselves.
  for (size_t k = 0; k < binding_.wheelsets().size(); ++k) {
    const double* wrench = d->userdata + UserData::kHeader + UserData::kPerWheelset * k;
    for (const int dof : binding_.wheelsets()[k].dofs) {
      contact -= 0.5 * (d->qvel[dof] - speed_[dof]) * mju_dot(d->cdof + 6 * dof, wrench, 6);
    }
  }
  for (const auto& w : binding_.wheelsets()) {
    const double before = speed_[w.spin_dof];
    const double after = d->qvel[w.spin_dof];
    book_.lent += 0.5 * h * w.lent_damping * (after * after - before * before);
    if (w.drive_actuator < 0) continue;
    const double torque = d->actuator_force[w.drive_actuator];
    book_.work_in += h * torque * 0.5 * (before + after);
    phs -= torque * 0.5 * (after - before);
  }
  book_.lost_creep += h * (d->userdata[UserData::kCreepPower] - contact);
  book_.work_in += h * d->userdata[UserData::kTrainPower];
  book_.train += h * std::abs(d->userdata[UserData::kTrainPower]);
  book_.lost_brakes += h * d->userdata[UserData::kBrakePower];
  book_.lost_contact += h * d->userdata[UserData::kContactPower];
  book_.lost_phs += h * (d->userdata[UserData::kPhsPower] - phs);
}

}  // namespace phs::vehicle
