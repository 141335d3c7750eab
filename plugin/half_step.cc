#include "plugin/half_step.h"

#include <algorithm>

namespace phs::plugin {

void AddApplied(const mjModel* m, mjData* d, double* force) {
  for (int i = 0; i < m->nv; ++i) force[i] += d->qfrc_applied[i];
  for (int body = 1; body < m->nbody; ++body) {
    const mjtNum* wrench = d->xfrc_applied + 6 * body;
    if (std::all_of(wrench, wrench + 6, [](mjtNum x) { return x == 0; })) continue;
    mj_applyFT(m, d, wrench, wrench + 3, d->xipos + 3 * body, body, force);
  }
}

double ActuatorForce(const mjModel* m, const mjData* d, int id, double ctrl) {
  if (m->actuator_dyntype[id] != mjDYN_NONE) ctrl = d->act[id - (m->nu - m->na)];
  if (m->actuator_dyntype[id] == mjDYN_NONE && m->actuator_ctrllimited[id] &&
      (m->opt.disableflags & mjDSBL_CLAMPCTRL) == 0) {
    ctrl = std::clamp(ctrl, m->actuator_ctrlrange[2 * id], m->actuator_ctrlrange[2 * id + 1]);
  }
  const double length = d->actuator_length[id];
  const double speed = d->actuator_velocity[id];
  const auto affine = [&](const mjtNum* p) { return p[0] + p[1] * length + p[2] * speed; };
  double force = 0;
  if (m->actuator_gaintype[id] == mjGAIN_FIXED) force = m->actuator_gainprm[mjNGAIN * id] * ctrl;
  if (m->actuator_gaintype[id] == mjGAIN_AFFINE) {
    force = affine(m->actuator_gainprm + mjNGAIN * id) * ctrl;
  }
  if (m->actuator_biastype[id] == mjBIAS_AFFINE)
    force += affine(m->actuator_biasprm + mjNBIAS * id);
  if (m->actuator_forcelimited[id]) {
    force = std::clamp(force, m->actuator_forcerange[2 * id], m->actuator_forcerange[2 * id + 1]);
  }
  return force;
}

}  // namespace phs::plugin
