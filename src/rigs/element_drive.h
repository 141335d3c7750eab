// A part on a bench that a force moves: where does it go?
//
//   m x" = P(t) - [offset + k x + k3 x³ + d v|v| + gas(x) + A p + friction(y, y', p, T, ...)]
//
// Names and signs as in element_bench.h; P > 0 pulls in the direction of x > 0. One step is the
// two-stage diagonally implicit method of Alexander (SIAM J. Numer. Anal. 14 (1977) 1006), second
// order and L-stable, so that a part that sticks does not ring:
//   v1 = v + g h a(t + g h, x1, v1),   x1 = x + g h v1,
//   v' = v + (1 - g) h a1 + g h a',   x' = x + (1 - g) h v1 + g h v',   g = 1 - 1/sqrt(2).
// What holds against the mass rises with the move of a stage: one root. Friction is brought along
// from the beginning of the step, with the mean speed to the stage and the speed at its end.
#pragma once

#include <vector>

#include "base/result.h"
#include "hydraulics/phs_system.h"
#include "rigs/rig.h"

namespace phs::rigs {

struct ElementStart {
  double x_m = 0, v_m_s = 0;
};

/// `motion.position_m[0]` holds P [N], its other channels are those of the bench. Position [m] at
/// every sample. `substeps`: steps per sample at least; more where the part swings faster on its
/// spring. Error: no mass, a law at the driven end.
Status RunElementByForce(const hydraulics::PhsSystem& system, const RigMotion& motion,
                         const ElementStart& start, int substeps, std::vector<double>* position);

}  // namespace phs::rigs
