// The creep laws of the simplified theory: FASTSIM itself (fastsim.h) and the table of it
// (creep_table.h). Both work on the normalised creepages; both may reduce the slope or blend the
// flexibilities before.
#pragma once

#include "rail/creep_law.h"

namespace phs::rail {

CreepLawRow FastsimRow();
CreepLawRow KalkerTableRow();

}  // namespace phs::rail
