// Which freedoms move a body.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

namespace phs::plugin {

/// Dofs of `body` and its ancestors, rising: those that a force on the body acts on.
std::vector<int> DofChain(const mjModel* m, int body);

}  // namespace phs::plugin
