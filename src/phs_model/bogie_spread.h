// The PHS of a Bo-Bo bogie from the model of one cylinder: what a rig has taught, in the vehicle.
//
// Cylinders 1, 2 lead left, right; 3, 4 trail right, left. Every cylinder and its friction as the
// one of the rig; its rod line becomes the cross lines L1 (rods 1, 2) and L4 (rods 3, 4), its bore
// line the diagonal lines L2 (bores 1, 3) and L3 (bores 2, 4), each with the oil, gas and
// accumulator of the rig's line. Static friction becomes presliding friction of the same level (its
// stiffness, damping and elastic share as in the file, by default those of bo_bo). Effects act on
// the lines and cylinders that theirs became; those of instruments, and a mass that moved with the
// rig's load cell, stay behind.
#pragma once

#include "hydraulics/phs_params.h"

namespace phs::phs_model {

/// True for one cylinder between two lines (a quarter rig).
bool IsQuarter(const hydraulics::PhsParams& params);

/// @pre IsQuarter(quarter)
hydraulics::PhsParams SpreadOverBogie(const hydraulics::PhsParams& quarter);

}  // namespace phs::phs_model
