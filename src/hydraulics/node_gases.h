// Gas volumes of a line as those of its node.
#pragma once

#include "hydraulics/node.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// The reservoir at static temperature T [K]: one gas, or parts of its diaphragm with stops of
/// their own.
void AddReservoir(const LineParams& line, double T, Node* node);
/// The blow-off accumulator, or parts of it with precharges of their own.
void AddAccumulator(const LineParams& line, double T, Node* node);

}  // namespace phs::hydraulics
