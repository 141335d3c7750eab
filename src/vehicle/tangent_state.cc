#include "vehicle/tangent_state.h"

#include <string>
#include <vector>

namespace phs::vehicle {

void AddToState(const mjModel* m, const Eigen::VectorXd& delta, mjData* d) {
  mj_integratePos(m, d->qpos, delta.data(), 1.0);
  mju_addTo(d->qvel, delta.data() + m->nv, m->nv);
  mju_addTo(d->act, delta.data() + 2 * m->nv, m->na);
}

void SetState(const mjModel* m, const mjData* base, const Eigen::VectorXd& delta, mjData* d) {
  mju_copy(d->qpos, base->qpos, m->nq);
  mju_copy(d->qvel, base->qvel, m->nv);
  mju_copy(d->act, base->act, m->na);
  mju_zero(d->qacc_warmstart, m->nv);
  d->time = base->time;
  AddToState(m, delta, d);
}

Eigen::VectorXd ActivationScale(const mjModel* m, const plugin::Binding& binding) {
  constexpr double kVolume = 1e-3;
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(m->na);
  for (const plugin::PhsBinding& phs : binding.phs()) {
    const std::vector<std::string>& names = phs.system->state_names();
    for (size_t k = 0; k < names.size(); ++k) {
      // Actuators with a state are the last ones.
      if (names[k].ends_with("_volume")) scale[phs.state_actuator[k] - (m->nu - m->na)] = kVolume;
    }
  }
  return scale;
}

}  // namespace phs::vehicle
