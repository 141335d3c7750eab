#include "vehicle/energy_book.h"

#include <algorithm>
#include <cmath>

namespace phs::vehicle {

using plugin::UserData;

double EnergyBook::Error() const {
  return work_in - (kinetic - start_kinetic) - stored - lost_creep - lost_contact - lost_dampers -
         lost_phs - lost_brakes;
}

double EnergyBook::RelativeError() const {
  const double lost = lost_creep + lost_contact + lost_dampers + lost_phs + lost_brakes;
  const double scale =
      std::max({std::abs(work_in), train, std::abs(lost), std::abs(kinetic - start_kinetic)});
  return scale > 0 ? Error() / scale : 0;
}

void EnergyKeeper::Step(const mjModel* m, const mjData* d) {
  const mjtNum* user = d->userdata;
  const std::array<double, kPowers> power = {
      user[UserData::kDrivePower],  user[UserData::kTrainPower],
      user[UserData::kCreepPower],  user[UserData::kContactPower],
      user[UserData::kDamperPower], user[UserData::kPhsPower],
      user[UserData::kBrakePower],  std::abs(user[UserData::kTrainPower]),
      user[UserData::kAppliedPower]};
  if (has_power_) {
    const double half = 0.5 * m->opt.timestep;
    const auto work = [&](size_t i) { return half * (power_[i] + power[i]); };
    book_.work_in += work(0) + work(1) + work(8);
    book_.lost_creep += work(2);
    book_.lost_contact += work(3);
    book_.lost_dampers += work(4);
    book_.lost_phs += work(5);
    book_.lost_brakes += work(6);
    book_.train += work(7);
  }
  power_ = power;
  has_power_ = true;
}

void EnergyKeeper::Read(const mjModel* m, const mjData* d) {
  const double* speed = binding_.Speed(d);
  momentum_.resize(static_cast<size_t>(m->nv));
  mj_mulM(m, d, momentum_.data(), speed);
  const double kinetic = 0.5 * mju_dot(momentum_.data(), speed, m->nv);
  double stored =
      d->energy[0] + d->userdata[UserData::kContactEnergy] + d->userdata[UserData::kPhsEnergy];
  for (const auto& elements : binding_.elements()) stored += elements->StoredEnergy(m, d);
  if (!has_start_) {
    start_stored_ = stored;
    book_.start_kinetic = kinetic;
    has_start_ = true;
  }
  book_.kinetic = kinetic;
  book_.stored = stored - start_stored_;
}

}  // namespace phs::vehicle
