// Is the step small enough for the stiffness? Eigenvalues of the discrete step about the running
// start tell; a step too large shows as a spectral radius far above one.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Dense>

#include "base/result.h"

namespace phs::vehicle {

/// Spectral radius of one mj_step about the state of `d` at step `h` (central differences in
/// position, speed and activation; forward position and spin angles left out: nothing depends on
/// them). `activations`: scale of each one's difference (tangent_state.h); empty: 1. Leaves `d` as
/// it was.
double StepSpectralRadius(mjModel* m, const mjData* d, double h,
                          const Eigen::VectorXd& activations = {});

/// Error if the model's step is unstable, with the largest stable step found by bisection. That is
/// also stored in `*largest` (0 if not even 1e-5 s is stable); null: it is not sought while the
/// step holds, which costs a seventh. Slow physical growth (hunting) is allowed: only growth faster
/// than exp(20 t/s) counts.
Status CheckStep(mjModel* m, const mjData* d, const Eigen::VectorXd& activations, double* largest);

}  // namespace phs::vehicle
