// Stiffness of the axle modes by hand: what small motion should find (axle_modes.h).
//
// With unit motion u of a pattern the linear springs of joints and tendons follow with their
// Jacobians J, each cylinder strokes s_i = d(length)/du, and line l loses the volume
//   w_l = sum over its chambers of (-A_bore s_i or +A_rod s_i)      [m3 per unit]
// so  K = sum k J^2  (springs)  + sum sigma0 s_i^2  (seals that stick)
//       + sum w_l^2 Re 1/C_l(omega)  (oil and gas),  C = V_oil/beta + V_a p_a/p^2 + V_g/(n p).
// n = 1 isothermal, the exponent of the polytropic law, and for the laws with an energy equation
// n = (1 + i omega tau gamma)/(1 + i omega tau) with gamma = 1.4 (linearised: isothermal when slow,
// adiabatic when fast). Effects of the catalogue, end stops and blow-offs are left out.
#pragma once

#include "analysis/axle_pattern.h"
#include "plugin/binding.h"

namespace phs::analysis {

/// Parts of the stiffness, totals over both axles [N m/rad or N/m].
struct ModeClosedForm {
  double springs = 0;
  double seals = 0;
  double lines = 0;
  double total() const { return springs + seals + lines; }
};

/// `d`: at rest after mj_forward.
ModeClosedForm CalcModeClosedForm(const plugin::Binding& binding, const mjModel* m, const mjData* d,
                                  const AxlePattern& pattern, const PatternJoints& joints,
                                  double frequency_Hz);

/// Strokes of the cylinders of one PHS per unit of the pattern, extension > 0 [m/rad or m/m].
std::vector<double> CalcStrokes(const plugin::PhsBinding& phs, const mjModel* m, const mjData* d,
                                const AxlePattern& pattern, const PatternJoints& joints);

}  // namespace phs::analysis
