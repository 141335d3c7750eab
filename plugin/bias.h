// MuJoCo's bias (Coriolis, centrifugal and weight forces) at a speed other than qvel.
//
// Recursive Newton-Euler in spatial vectors [rotation, translation] about the centre of mass of the
// tree (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 5.3; MuJoCo's mj_comVel and
// mj_rne): with the motion c_j of each dof, down the tree
//   c'_j = v x c_j,   v += c_j w_j,   a += c'_j w_j   (a = -gravity at the world)
//   f = I a + v x* I v
// and back, bias_j = c_j . (sum of f of the bodies that j moves). In one pass, as only the bias is
// wanted: mjData keeps its velocities.
#pragma once

#include <mujoco/mujoco.h>

namespace phs::plugin {

/// Bias at `speed` [nv], at the positions that (m, d) has worked out.
void CalcBiasAt(const mjModel* m, mjData* d, const double* speed, double* bias);

}  // namespace phs::plugin
