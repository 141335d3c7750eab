// A line as the node of its volume balance, with its gas volumes.
#pragma once

#include "hydraulics/node.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// Oil, air and gas of `line` at static temperature T [K]; laws of effects are not in it.
Node MakeNode(const LineParams& line, double T);
/// The reservoir at static temperature T [K]: one gas, or parts of its diaphragm with stops of
/// their own.
void AddReservoir(const LineParams& line, double T, Node* node);
/// The blow-off accumulator, or parts of it with precharges of their own.
void AddAccumulator(const LineParams& line, double T, Node* node);

}  // namespace phs::hydraulics
