// What the catalogue does not hold, as found in data: a law given by a formula with units
// (formula.h). The unit of its coefficients says what it is and where it acts:
//
//   c1_N …         a force on the piston beside friction        targets: cylinders
//                  over F too: what the load cell shows beyond F, that it carries
//   c1_m3 …        a volume that a line takes up, over its p     targets: lines
//   c1_m3_per_s …  a flow out of a line over its p and t         targets: lines
//                  (0 at p = 0, unless t alone drives it)
//                  or from bore to rod over p = p_bore - p_rod   targets: cylinders
//   c1_m …         what the piston's sensor shows beyond it      targets: cylinders
//   c1_Pa …        what a pressure sensor shows beyond it        targets: lines
//
// p of a line is its pressure above static, of a cylinder's flow the difference above the static
// one. Of readings x, v, p, q, t and F are those of the true state, p and q
// of bore and rod, also on a line. Example: formula: "c1*(max(p-9e6[Pa],0[Pa])/1e6[Pa])" with
// c1_m3_per_s: 2e-7 on L2, a valve that opens 9 MPa above static. Not passive by construction: it
// is what was measured.
#pragma once

#include "hydraulics/extension.h"

namespace phs::effects {

inline constexpr int kFormulaCoefficients = 6;  ///< of one formula at most

const hydraulics::EffectInfo& UnlistedInfo();
/// True of an effect `unlisted` that gives or takes oil: one of its coefficients is a volume or a
/// flow.
bool ActsOnOil(const hydraulics::EffectParams& effect);

}  // namespace phs::effects
