// The state of a model about a base as one vector: [position as tangent vector (nv); speed (nv);
// activation (na)].
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>

#include "plugin/binding.h"

namespace phs::vehicle {

inline int TangentSize(const mjModel* m) { return 2 * m->nv + m->na; }

/// Moves the state of `d` by `delta`.
void AddToState(const mjModel* m, const Eigen::VectorXd& delta, mjData* d);

/// Gives `d` the time and state of `base` moved by `delta`, without a warm start.
void SetState(const mjModel* m, const mjData* base, const Eigen::VectorXd& delta, mjData* d);

/// What one unit of each activation is in probing the model by differences, against a length of one
/// metre: 1, but 1e-3 where oil that has passed a resistance is counted in m3. A tenth of a cubic
/// centimetre in a chamber is half a megapascal, beyond the linear part of a throttle.
Eigen::VectorXd ActivationScale(const mjModel* m, const plugin::Binding& binding);

}  // namespace phs::vehicle
