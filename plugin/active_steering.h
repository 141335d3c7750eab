// Active steering: a servo turns each axle in its frame by what the curvature asks for.
//
//          gyroscope, tachometer            controller          actuator (MuJoCo's own)
//   frame ---- omega_z, V ----> kappa = omega_z/V ----> demand = a kappa
//                                T dq/dt = demand - q,   M = k (q - psi)
//
//   omega_z  yaw rate of the frame about its own upright axis, > 0 to the left [rad/s]
//   V        speed of the frame along itself, at least 1 m/s [m/s]
//   a        distance of the axle before the origin of the frame [m]: a radial axle stands at
//            psi = a kappa against its frame, the leading one to the left in a left-hand curve
//   q        what the servo is told: filter and time constant T are the actuator's (dyntype="filter")
//   M        moment on the axle, the reverse on the frame; k is gain and -bias of the actuator
//
// A model says <tuple name="steering:NAME"> with the actuator, on the yaw hinge of the body that
// holds the axle and hangs on the frame. The controller remembers nothing: q is an activation.
// It is the feedforward by curvature of the literature (Fu et al., Railway Engineering Science 28
// (2020), section on steering of solid wheelsets), with the curvature from the bogie's own gyroscope.
#pragma once

#include <mujoco/mujoco.h>

#include <cstring>

#include "base/result.h"

namespace phs::plugin {

/// One servo of a model.
struct ActiveSteering {
  int actuator = -1;
  int frame = -1;    ///< body
  double ahead = 0;  ///< a [m]
};

/// Calls `visit(ActiveSteering)` for each; allocates nothing.
template <typename Visit>
void ForEachSteering(const mjModel* m, Visit visit);

/// Errors: an actuator that is none on a hinge, or has no filter.
Status CheckActiveSteering(const mjModel* m);

/// a kappa where (m, d) has positions and velocities worked out [rad].
double CalcSteeringDemand(const mjModel* m, const mjData* d, const ActiveSteering& s) noexcept;

/// The demands as the controls of the servos.
void ControlSteering(const mjModel* m, mjData* d) noexcept;

/// The servos stand where they are told to at (m, d): for readers of a steady state.
void SettleSteering(const mjModel* m, mjData* d) noexcept;

// Implementation of the template.

inline constexpr char kSteeringTuple[] = "steering:";

ActiveSteering SteeringOf(const mjModel* m, int actuator) noexcept;

template <typename Visit>
void ForEachSteering(const mjModel* m, Visit visit) {
  for (int i = 0; i < m->ntuple; ++i) {
    const char* name = m->names + m->name_tupleadr[i];
    if (std::strncmp(name, kSteeringTuple, sizeof kSteeringTuple - 1) != 0) continue;
    visit(SteeringOf(m, m->tuple_objid[m->tuple_adr[i]]));
  }
}

}  // namespace phs::plugin
