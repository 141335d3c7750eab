// A force written as a formula, evaluated in the model: the law of the effect `unlisted`.
//
//   formula: "c1*s*(p/5e5[Pa]) + c2*sin(2*pi*x/0.0025[m])"
//
// Variables: x position [m], v speed [m/s], s direction of friction (-1 … 1, turns over the
// friction's presliding or ramp, so nothing flickers at rest), p and q pressure of bore and rod
// above static [Pa] (element bench: p is its pressure channel), t time [s], dT temperature above
// the model's [K]. Coefficients c1 … c6 [N]. Numbers may carry a unit in brackets:
// 0.0025[m], 3[N/m], 2[m/s]. Operators + - * / ^ (a plain number as exponent), functions sin, cos,
// exp, tanh, abs, sqrt, constant pi. The dimension of every part is checked: sums need equal
// dimensions, functions plain numbers, the whole is a force [N].
//
// Evaluation does not allocate. Sign: F > 0 adds to tension. Such a force need not be passive.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/extension.h"

namespace phs::effects {

class ForceFormula final : public hydraulics::ForceLaw {
 public:
  /// `coefficients`: values of c1 … in N. Errors: syntax, unknown names, dimensions, depth.
  static Result<ForceFormula> Parse(const std::string& text,
                                    const std::map<std::string, double>& coefficients);
  double Force(const hydraulics::ForcePlace& place) const noexcept override;

  static constexpr int kMaxDepth = 24;  ///< of the evaluation stack

  enum class Code {
    kNumber,
    kVariable,
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kPower,
    kNegate,
    kSin,
    kCos,
    kExp,
    kTanh,
    kAbs,
    kSqrt
  };
  /// One step of the reverse Polish form.
  struct Step {
    Code code = Code::kNumber;
    double number = 0;
    int variable = 0;
  };

 private:
  explicit ForceFormula(std::vector<Step> steps) : steps_(std::move(steps)) {}
  std::vector<Step> steps_;
};

}  // namespace phs::effects
