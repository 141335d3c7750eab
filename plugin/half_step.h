// A step whose forces know the speed of their own instant.
//
// MuJoCo's Euler step is a leapfrog: v_{n+1} = v_n + h a_n, x_{n+1} = x_n + h v_{n+1}. Positions
// and states are those of t_n, speeds those of t_n - h/2. A force of position alone does not mind;
// a creep force mixes both (eta = y'/V - psi), and with v_n its phase is half a step late: an angle
// of attack of omega h/2 in a curve, a push or pull on every oscillation.
// So the forces are taken at
//   w = v_n + h/2 a,    M a = f(x_n, w, z_n, t_n),                                          (1)
// the speed of t_n itself, and a is what the step applies. With M constant (1) is the trapezoidal
// rule for every force that depends on speed and the leapfrog for every other: second order, stable
// for any damping that the matrix below knows (linkages between branches are not in it, so very
// stiff dampers there still limit the step). Kinetic energy changes by h f.w without remainder.
// States (bristles, mountings, gas, flows) advance with v_{n+1}, which carries x_n exactly to
// x_{n+1}; flows and volumes, whose last stage lies at t_{n+1}, with v_{n+1} + (v_{n+1} - v_n)/2 there:
// oil behind a throttle hardly yields and would lag by half a step otherwise.
//
// (1) is solved by two Newton steps from w = v_n with (M + h/2 C) da = f(w) - M a, C the symmetric
// part of -df/dw: contacts, cylinders, elements (elements.h). C of contacts and elements is that at
// v_n; that of the cylinders is, in the second step, the secant of both, so that dry friction that
// would be thrown across zero is caught. Nothing else is iterated, so a is a pure function of (m,
// time, qpos, qvel, act, ctrl) and comes out the same from every mj_forward.
//
// MuJoCo itself solves (M + h B) a = f + ... with the damping B of joints. The forces handed over
// hold h B a on top, so that its step makes the a of (1).
//
// Left at v_n: actuators that are neither cylinders nor hold the speed; what constraints (limits,
// equalities) add to a is not in w.
// Of first order: a seal that slides holds the level of the mean speed of the step behind it, half a
// step ago. It shows where pistons slide at decimetres per second (docs/convergence.md).
#pragma once

#include <mujoco/mujoco.h>

namespace phs::plugin {

/// Adds applied forces: qfrc_applied and xfrc_applied.
void AddApplied(const mjModel* m, mjData* d, double* force);

/// Force of actuator `id` at control `ctrl` by MuJoCo's rules for fixed and affine gains and
/// biases; 0 for other kinds.
double ActuatorForce(const mjModel* m, const mjData* d, int id, double ctrl);

}  // namespace phs::plugin
