// The state of a model about a base as one vector: [position as tangent vector (nv); speed (nv);
// activation (na)].
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>

namespace phs::vehicle {

inline int TangentSize(const mjModel* m) { return 2 * m->nv + m->na; }

/// Moves the state of `d` by `delta`.
void AddToState(const mjModel* m, const Eigen::VectorXd& delta, mjData* d);

/// Gives `d` the time and state of `base` moved by `delta`, without a warm start.
void SetState(const mjModel* m, const mjData* base, const Eigen::VectorXd& delta, mjData* d);

}  // namespace phs::vehicle
