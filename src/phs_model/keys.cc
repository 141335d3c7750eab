#include "phs_model/keys.h"

#include "base/words.h"
#include "hydraulics/gas_law.h"

namespace phs::phs_model {

const std::vector<KeyRow>& OtherKeys() {
  using enum FilePart;
  static const std::string laws = JoinWords(hydraulics::GasLawNames());
  static const std::vector<KeyRow> rows = {
      {kWhole, "name", "text", "required", "of the model"},
      {kWhole, "description", "text", "empty", "what it is"},
      {kWhole, "source", "text", "empty", "where its numbers come from"},
      {kWhole, "balance", JoinWords(kBalances), kBalances[0],
       "all elements of a line share its pressure; or the order reservoir, oil, accumulator of the "
       "thesis ([gas_laws.md](gas_laws.md))"},
      {kWhole, "cylinder_defaults", "block", "",
       "the keys of a cylinder but its names and lines, for all of them"},
      {kWhole, "cylinders", "list of 1 … 16", "required", ""},
      {kWhole, "line_defaults", "block", "", "the keys of a line but its name, for all of them"},
      {kWhole, "lines", "list of 0 … 16", "none", ""},
      {kWhole, "friction.model", JoinWords(kModels), "presliding",
       "no friction; level over speed alone; a bristle that sticks before it slides"},
      {kWhole, "friction.curve", JoinWords(kCurves), "table", "level over speed"},
      {kWhole, "friction.speed_m_s", "m/s, rising, with 0", "−0.05 … 0.05", "table: speeds"},
      {kWhole, "friction.force_N", "N, of the speed's sign, 0 at 0", "−1900 … 2150",
       "table: level at each speed; straight between, last piece continued"},
      {kWhole, "effects", "block", "none", "what the real PHS has beside it, see below"},
      {kCylinder, "name", "text, each once", "required",
       "cylinders of a Bo-Bo: \"1\", \"2\" leading left, right; \"3\", \"4\" trailing right, left"},
      {kCylinder, "bore_line", "name of a line", "empty",
       "line of the bore chamber; empty: open to the atmosphere"},
      {kCylinder, "rod_line", "name of a line", "empty", "the same of the rod chamber"},
      {kLine, "name", "text, each once", "required", ""},
      {kLine, "reservoir.law", laws, "isothermal",
       "gas law; `ideal` and `bwr` with energy equation ([gas_laws.md](gas_laws.md))"},
      {kLine, "reservoir.charge_pressure_Pa", "Pa, 1e4 … 1e8", "none",
       "instead of `gas_volume_m3`: the shell was filled with gas at this pressure, absolute, then "
       "oil brought it to the static pressure"},
      {kLine, "accumulator.law", laws, "isothermal", "gas law"},
  };
  return rows;
}

}  // namespace phs::phs_model
