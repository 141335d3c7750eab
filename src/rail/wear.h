// Wear and rolling contact fatigue from the energy that creepage dissipates.
//
// Wear number of a contact: T-gamma = |x xi| + |y eta| [N = J per metre run], without the spin
// term; spin is reported apart as |moment phi|.
//
// All functions below are empirical. They rank designs on one line; they do not predict years of
// life. They take T-gamma >= 0 of one contact.
#pragma once

#include "rail/creep_law.h"

namespace phs::rail {

struct TGamma {
  double slip = 0;  ///< |x xi| + |y eta| [N]
  double spin = 0;  ///< |moment phi| [N]
};
TGamma CalcTGamma(const CreepInput& creepage, const CreepForce& force) noexcept;

/// Wear regime of a wheel: mild on the tread, severe at the start of flange contact, catastrophic.
enum class WearRegime { kMild, kSevere, kCatastrophic };
const char* NameOf(WearRegime regime);

/// Wheel wear of Pearce and Sherratt (British Rail Research, 1991): cross-section area worn off per
/// km run [mm^2/km], D = wheel diameter [m]; with D in mm and T in N:
///   T <= 100: 0.25 T/D  mild;   100 … 200: 25/D  severe;   > 200: (1.19 T - 154)/D  catastrophic.
/// The published function jumps from 25/D to 84/D at 200 N. Coefficients from secondary sources.
double CalcWornAreaPerKm(double t_gamma, double wheel_diameter) noexcept;
WearRegime WearRegimeOf(double t_gamma) noexcept;

/// Wear rate of wheel steel R8T on UIC60 900A (University of Sheffield twin-disc tests; Lewis,
/// Dwyer-Joyce 2004): mass per metre run and mm^2 of contact [ug/(m mm^2)], with q = T-gamma/area
/// in N/mm^2:
///   q <= 10.4: 5.3 q;   10.4 … 77.2: 55;   > 77.2: 61.9 (q - 77.2) + 55.
/// `contact_area` [m^2] > 0. Coefficients from secondary sources.
double CalcSheffieldWearRate(double t_gamma, double contact_area) noexcept;

/// Damage of the rail by rolling contact fatigue per axle pass (whole life = 1); Burstow, Whole
/// life rail model (RSSB, 2003). Rises from 0 at 20 N to 1e-5 at 65 N, falls to 0 at 175 N; beyond,
/// wear removes cracks faster than they grow: with `net_of_wear` the line goes on below zero,
/// without it the damage is 0.
///   20 … 65: 2.22e-7 T - 4.44e-6;   > 65: 1e-5 (175 - T)/110.
double CalcRcfDamage(double t_gamma, bool net_of_wear) noexcept;

}  // namespace phs::rail
