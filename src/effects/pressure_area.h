// Pressure on an area that the model does not know: F = A p. Sign: A > 0, pressure pushes in the
// sense of tension. On a bench p is its pressure channel [Pa]. Elsewhere it is the rise, above z p0,
// of each chamber that hangs on a target line: a bore other than declared, a hose that straightens
// and pushes on its cylinder. p0: static pressure; z (zeroed_over_static): 1 where the load cell was
// set to zero with the lines filled, 0 where empty. A hose thrusts less the straighter it is, a
// seal's area bears more or less with the pressure: A p (|p|/10 MPa)^(n-1) (exponent). Pressure that
// is trapped behind a ring comes late, T dp'/dt = p - p' (late_s). It is a force alone; the oil that
// moves is that of bore_m and rod_m.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

const hydraulics::EffectInfo& PressureAreaInfo();

}  // namespace phs::effects
