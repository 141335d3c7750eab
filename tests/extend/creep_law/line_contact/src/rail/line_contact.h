// Carter's theory on an ellipse cut into strips along rolling (carter.h), longitudinal creepage
// only: 1/R follows from Hertz's line contact in each strip, N' = pi G a²/(2 (1 - nu) R) per
// length, so that  a'/a = 1 - |xi| R/(f a).  Lateral creepage and spin turn the direction: the
// force stands against the total slip at the patch's centre.
#pragma once

#include "rail/creep_law.h"

namespace phs::rail {

CreepLawRow LineContactRow();

}  // namespace phs::rail
