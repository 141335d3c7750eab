// A valve that feeds a line from a supply while its pressure is below the opening pressure p_o:
// an anti-cavitation check beside a charge pump. It lets nothing out.
//   q = G d (d/5 MPa)^(n-1) into the line, d = p_o - p > 0
// n = 1/2 an orifice, 1 a spring that yields in proportion. The oil comes from outside with the
// supply's own work. A line whose static pressure is below p_o is fed there too, as it stands.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& MakeupValveInfo();

}  // namespace phs::effects
