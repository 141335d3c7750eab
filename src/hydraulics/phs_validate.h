// Whether the parameters of a PHS make sense: every number inside its range (phs_numbers.h), names
// that are there once, and what numbers ask of each other.
#pragma once

#include "base/result.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// The first fault: where, what, what is allowed.
Status Validate(const PhsParams& params);

}  // namespace phs::hydraulics
