// A table of creepage cases, evaluated with one creep law: `phs contact --cases`.
//
// Columns read, one patch per row: a_mm, b_mm (semi-axes along and across), FN_N, mu, G_MPa, nu,
// xi, eta, phi_rad_per_mm. Added: Fx_N, Fy_N, Mz_Nmm on the rail, CONTACT's sign (creep_law.h). All
// columns of the input are passed through, text included.
#pragma once

#include <string>

#include "base/result.h"
#include "base/table.h"
#include "rail/creep_law.h"

namespace phs::rail {

/// `params.material` is taken from the rows. A wrong cell gives an error with its line.
Result<Table> CalcCreepCases(const Table& cases, const CreepLawParams& params);
/// The same with the defaults of a method.
Result<Table> CalcCreepCases(const Table& cases, const std::string& method);

/// Writes a table with its text cells as they were read, numbers in their shortest exact form.
Status WriteCaseTable(const std::string& path, const Table& table);

}  // namespace phs::rail
