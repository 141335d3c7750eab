// The creep law `linear`: Kalker's linear theory (kalker.h), without a limit.
#pragma once

#include "rail/creep_law.h"

namespace phs::rail {

CreepLawRow LinearCreepRow();

}  // namespace phs::rail
