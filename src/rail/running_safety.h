// Limits against derailment and track shift.
#pragma once

namespace phs::rail {

/// Largest Y/Q before the flange climbs (Nadal 1896): (tan beta - mu)/(1 + mu tan beta) =
/// tan(beta - atan mu), beta = flange angle [rad] in (0, pi/2), mu >= 0.
double CalcNadalLimit(double flange_angle, double friction);

/// Largest sum of guiding forces of a wheelset over 2 m of track [N] (Prud'homme 1967):
/// k1 (10 kN + 2 Q0/3). `static_wheel_load` Q0 [N]; k1 = 1 for locomotives and coaches, 0.85 for
/// freight wagons. Made for 1435 mm track with timber sleepers and 22.5 t.
double CalcTrackShiftLimit(double static_wheel_load, double k1);

}  // namespace phs::rail
