// Springs and dampers that MuJoCo puts along tendons: linkages between axles.
#pragma once

#include <mujoco/mujoco.h>

namespace phs::plugin {

/// Calls `visit(dof, dlength_dqpos)` for every dof that moves tendon `t`. Reads the tendon Jacobian
/// of (m, d), dense or sparse.
template <typename Visit>
void ForEachDofOfTendon(const mjModel* m, const mjData* d, int t, Visit visit) {
  const bool sparse = mj_isSparse(m) != 0;
  const int count = sparse ? d->ten_J_rownnz[t] : m->nv;
  const int first = sparse ? d->ten_J_rowadr[t] : t * m->nv;
  for (int k = 0; k < count; ++k) {
    const double moment = d->ten_J[first + k];
    if (moment != 0) visit(sparse ? d->ten_J_colind[first + k] : k, moment);
  }
}

/// Calls `visit(tendon, dof, dlength_dqpos)` for every dof that moves a tendon with a spring or a
/// damper.
template <typename Visit>
void ForEachTendonDof(const mjModel* m, const mjData* d, Visit visit) {
  for (int t = 0; t < m->ntendon; ++t) {
    if (m->tendon_stiffness[t] == 0 && m->tendon_damping[t] == 0) continue;
    ForEachDofOfTendon(m, d, t, [&](int dof, double moment) { visit(t, dof, moment); });
  }
}

/// Force of the spring of tendon `t` along it, > 0 lengthens [N or N m].
inline double TendonSpringForce(const mjModel* m, const mjData* d, int t) {
  return m->tendon_stiffness[t] * (m->tendon_lengthspring[t] - d->ten_length[t]);
}

}  // namespace phs::plugin
