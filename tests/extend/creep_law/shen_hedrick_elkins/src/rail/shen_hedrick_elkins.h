// Linear creep force cut back to the friction limit (Shen, Hedrick, Elkins, A comparison of
// alternative creep force models for rail vehicle dynamic analysis, 8th IAVSD (1983) 591):
//   r = |F_linear|/(f N),   |F| = f N (r - r²/3 + r³/27) for r < 3, else f N
// in the direction of the linear force, spin included. The spin moment is cut back alike.
#pragma once

#include "rail/creep_law.h"

namespace phs::rail {

CreepLawRow ShenHedrickElkinsRow();

}  // namespace phs::rail
