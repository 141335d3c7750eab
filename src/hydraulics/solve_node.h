// Solving the volume balance of a node (node.h).
#pragma once

#include "hydraulics/node.h"

namespace phs::hydraulics {

/// Solves the balance. `ambient` [K]; `state` = all states (gas temperature deviations) or null.
/// `near`: a solution close by, from which to start where there is no closed form; or null.
NodeState SolveNode(const Node& node, double D, double ambient, const double* state,
                    const NodeState* near = nullptr) noexcept;
/// The same in place of `at`, from where it starts if it is a solution close by (slope > 0).
void SolveNodeAt(const Node& node, double D, double ambient, const double* state,
                 NodeState* at) noexcept;
/// One step of Newton's method in place of `at`, a solution or an iterate close by, for callers that
/// iterate anyway; solved where the step would go far or there is a closed form. Returns how far
/// the step led beyond the tangent there, relative to p; what it leaves is of the order of its
/// square.
double StepNode(const Node& node, double D, double ambient, const double* state,
                NodeState* at) noexcept;
/// The same as SolveNode for a reservoir of real gas, with its density as the unknown: the pressure
/// is explicit in it. False where the diaphragm rests on a stop (then the general solver takes
/// over).
bool SolveRealGasNode(const Node& node, double D, double ambient, const double* state, double guess,
                      NodeState* out) noexcept;
/// Left side of the balance at p: D and its slope.
double CalcAbsorbed(const Node& node, double p, double ambient, const double* state,
                    double* slope) noexcept;
/// Energy stored above the static state [J].
double CalcNodeEnergy(const Node& node, double p, double ambient, const double* state) noexcept;

}  // namespace phs::hydraulics
