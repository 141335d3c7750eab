// The start of a run: the vehicle placed on the track, settled under its weight and rolling.
#pragma once

#include <mujoco/mujoco.h>

#include "base/result.h"
#include "plugin/binding.h"

namespace phs::plugin {

/// Solves qacc = 0 for every freedom but spin and forward motion, at the running speed, by Newton
/// with a finite-difference Jacobian (minimum norm where the equilibrium is indifferent, as
/// sideways on straight track); fills the key named "test" with it, if the model has one. Seals
/// hold nothing there and throttled chambers have the pressure of their line; a cylinder on a
/// yielding mounting begins unloaded. Roots are free joints, or slides along x (a vehicle guided
/// along straight track). The model must be registered, since the forces come from its callbacks.
/// Error if the vehicle cannot stand on its track.
Status PrepareStart(mjModel* m, const Binding& binding);

/// Resets `d` to the start: key "test" if there is one, else MuJoCo's own reset.
void ResetToStart(const mjModel* m, mjData* d);

}  // namespace phs::plugin
