// The thesis's own procedure for the pressure of a line (its Figs 6-7 and 7-4), as an option beside
// the unified balance: one element takes the whole volume at a time,
//   1. the reservoir's gas, as if the oil were rigid, until it is "full": until its stiffness
//      p n/V_g reaches that of the oil, beta/V_oil (or the diaphragm is on its stop);
//   2. then the oil alone;
//   3. above the precharge of a blow-off accumulator, its gas alone.
// Where the reservoir is full is not stated in the thesis; equal stiffness is our reading and keeps
// the curve smooth there. Pressures are continuous; the unified balance is softer everywhere.
#pragma once

#include "hydraulics/node.h"

namespace phs::hydraulics {

NodeState SolveSequential(const Node& node, double D, double ambient, const double* state) noexcept;

}  // namespace phs::hydraulics
