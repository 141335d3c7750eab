// A law written as a formula, evaluated in the model: what the effect `unlisted` takes.
//
//   formula: "c1*s*(p/5e5[Pa]) + c2*sin(2*pi*x/0.0025[m])"
//
// Variables: x position [m], v speed [m/s], s direction of friction (-1 … 1, turns over the
// friction's presliding or ramp, so nothing flickers at rest), p and q pressure of bore and rod
// above static [Pa] (element bench: p is its pressure channel; a line: p is its own), t time [s],
// dT temperature above the model's [K]; of readings also F, the force that the load cell carries,
// tension > 0 [N]. Coefficients c1 … c6 have the unit of the whole. Numbers
// may carry a unit in brackets: 0.0025[m], 3[N/m], 2[m/s]. Operators + - * / ^ (a plain number as
// exponent), functions sin, cos, exp, tanh, abs, sqrt, max(a, b), constant pi. The dimension of
// every part is checked: sums need equal dimensions, functions plain numbers, the whole is what is
// asked for: a force [N], a volume [m^3], a flow [m^3/s], a length [m] or a pressure [Pa].
//
// Evaluation does not allocate.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "effects/formula_words.h"
#include "hydraulics/extension.h"

namespace phs::effects {

/// Dimension of a name's ending: "N_per_m", "m3_per_s", "m_s" (m/s), "Ns_per_m", "V"; "" is a plain
/// number. Error: an unknown unit.
Result<Dimension> DimensionOf(const std::string& ending);

/// What a formula gives.
enum class FormulaUnit { kForce, kVolume, kFlow, kLength, kPressure };
/// "N", "m3", "m3_per_s", "m", "Pa": as in names of coefficients, c1_N.
const char* UnitSuffix(FormulaUnit unit);

class Formula {
 public:
  /// `coefficients`: values of c1 … in that unit. Errors: syntax, unknown names, dimensions, depth,
  /// a part that has no finite value whatever the variables and coefficients are (c1/0).
  static Result<Formula> Parse(const std::string& text,
                               const std::map<std::string, double>& coefficients,
                               FormulaUnit unit = FormulaUnit::kForce);
  /// A formula of this dimension (`words`: for people, "force [N]") with further names.
  static Result<Formula> Parse(const std::string& text, const FormulaNames& names,
                               const Dimension& whole, const std::string& words);
  double Value(const hydraulics::ForcePlace& place) const noexcept;
  /// Symbol of the first variable that is not among `allowed`; empty if there is none.
  std::string VariableOtherThan(const std::string& allowed) const;
  bool Uses(const std::string& variable) const;

 private:
  explicit Formula(std::vector<FormulaStep> steps) : steps_(std::move(steps)) {}
  std::vector<FormulaStep> steps_;
};

}  // namespace phs::effects
