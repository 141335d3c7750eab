// Carter's theory of the line contact on an elliptic patch cut into strips along rolling (carter.h).
//
// Of the middle strip R follows from Hertz, a² = 4 (1 - nu) N' R/(pi G), N' = 3 N/(4 b); the strips
// beside it have the same R. The creepage is s = sqrt(xi² + eta²), the force stands against it.
// Without spin. In the limit of a wide patch C11 is Kalker's pi²/(4 (1 - nu)).
#pragma once

#include "rail/creep_law.h"

namespace phs::rail {

CreepLawRow LineContactRow();

}  // namespace phs::rail
