// Changes of a PHS model that was read already.
#pragma once

#include <string>

#include "phs_model/phs_model.h"

namespace phs::phs_model {

/// Effects first, then parameters (theirs, too), then the failures that concern `system`.
Status ApplyChanges(const PhsChanges& changes, const std::string& system,
                    hydraulics::PhsParams* params);

}  // namespace phs::phs_model
