// What filling a PHS at one temperature and using it at another does: pressures, gas and oil of the
// closed lines follow, the pistons at rest.
//
// A line was filled at T_f to p_f with V_oil and gas V_f. At T, with the housing's volume kept,
//   a V_oil (T - T_f) = (V_oil/beta)(p - p_f) + [V_f - V_g(p, T)] + [V_acc - V_a(p, T)] + air
// a: expansion of the oil against its housing. It is the volume balance of node.h, with the oil's
// expansion as what is pushed in and the gas law of the reservoir for V_g(p, T). So a perfect gas
// alone (beta infinite, a = 0) follows p = p_f T/T_f (Gay-Lussac) and a line without gas
// p = p_f + beta a (T - T_f), 0.9 MPa per kelvin. The blow-off accumulator's gas is shut in its
// shell: its opening pressure is that of its law at constant volume, p_a T/T_f of a perfect gas.
// Viscosity follows temperature_K by itself (oil.h). The bulk modulus stays as declared.
// Expansion: mineral oil 7e-4 1/K (oil.h) less three times the linear expansion of steel.
#pragma once

#include "base/result.h"
#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// The same PHS stated at its temperature: filled_at_K and the lines' temperatures are then 0
/// again. Unchanged where filled_at_K is 0. Errors: a line that has lost its pressure (below 10 kPa)
/// or exceeds 100 MPa; a reservoir that is empty of oil, its gas filling the shell.
Result<PhsParams> AtItsTemperature(const PhsParams& stated);

}  // namespace phs::hydraulics
