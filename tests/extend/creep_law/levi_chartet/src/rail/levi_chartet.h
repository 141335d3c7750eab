// Levi and Chartet's saturation of the linear creep force (Chartet, La théorie statique du
// déraillement d'un essieu, Revue générale des chemins de fer 69 (1950) 365):
//   |F|^-n = |F_linear|^-n + (f N)^-n,   n = 2 unless the option says otherwise
// in the direction of the linear force. The spin moment is cut back alike.
#pragma once

#include "rail/creep_law.h"

namespace phs::rail {

CreepLawRow LeviChartetRow();

}  // namespace phs::rail
