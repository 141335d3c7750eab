// The multibody model linearised about a running state: x' = A x, x = (dq, dv, dz): tangent of the
// position, speeds, activations (hydraulic and friction states).
//
//   dq' = dv                                    (running straight: no rotation but the spins)
//   dv' = d qacc/dq dq + d qacc/dv dv + d qacc/dz dz,   dz' likewise from act_dot
// by central differences of mj_forward's accelerations, which are those of continuous time:
//   - forces and state rates are taken at an instant (plugin::InstantForces);
//   - the speed hold is a driver, not part of the vehicle: drive torques stay as they are.
// Everything the plugin computes is a pure function of (q, v, z), so nothing escapes the
// differences.
#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "plugin/binding.h"

namespace phs::analysis {

struct LinearModel {
  int nv = 0;
  int na = 0;
  Eigen::MatrixXd matrix;  ///< A, (2 nv + na) square
};

/// Steps of the central differences.
struct DifferenceSteps {
  double position = 1e-7;    ///< [m, rad]
  double speed = 1e-6;       ///< [m/s, rad/s]
  double activation = 1e-7;  ///< [unit of the state]
};

/// Linearises about `running`, a state of straight running without acceleration (StartAtSpeed).
/// Engine settings of `m` change for the time of the call only.
LinearModel Linearise(mjModel* m, const plugin::Binding& binding, const mjData* running,
                      const DifferenceSteps& steps = {});

/// Speed and rotation of every body but the world in a state of `model`'s first nv entries: motion
/// of the body's origin and attitude, world axes (x forward, y left, z up).
struct BodyMotion {
  std::string body;
  std::complex<double> translation[3];  ///< [m]
  std::complex<double> rotation[3];     ///< roll, pitch, yaw [rad]
};
std::vector<BodyMotion> BodyMotions(const mjModel* m, const mjData* running,
                                    const Eigen::VectorXcd& state);

}  // namespace phs::analysis
