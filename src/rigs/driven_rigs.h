// Rigs with other inputs than one position: all four pistons of a full rig, a piston that a force
// drives, a cylinder whose pressures are given.
//
// Driven by a force P [N], tension > 0, which pulls the piston with the mass m that moves with it:
//   m x'' = P(t) - F(x, x', states)       F: tension force of the cylinder with its friction
// One step is backward Euler in x with all states of the PHS advanced along the trial motion;
// P - F falls with the move, so secants find it. First order in the step: an
// oscillation of m on the oil is followed where steps are far below its period (`substeps`), else
// damped away; the path on which P = F is met at any step. At start x = 0, at rest.
#pragma once

#include <vector>

#include "hydraulics/phs_system.h"
#include "rigs/rig.h"

namespace phs::rigs {

/// Position of every cylinder given: channels pistons, forces, line pressures.
void RunPistons(const hydraulics::PhsSystem& system, const RigOptions& options,
                const RigMotion& motion, const std::vector<std::vector<double>>& speed,
                RigPrediction* out);

/// `motion.position_m[0]` holds P [N]; channels piston, F, p_bore, p_rod.
void RunForce(const hydraulics::PhsSystem& system, const RigOptions& options,
              const RigMotion& motion, RigPrediction* out);

}  // namespace phs::rigs
