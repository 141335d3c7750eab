// The words of a formula and what they do: units, variables, operators. Parser and evaluation share
// them, so that what is folded while reading is what would come out in a run.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace phs::effects {

/// Exponents of m, kg, s, K, A.
using Dimension = std::array<double, 5>;

/// What the words of a law mean beyond the variables of every formula.
struct FormulaNames {
  struct Number {
    double value = 0;
    Dimension dimension = {};
  };
  std::map<std::string, Number> numbers;
  /// States of the law and further channels, in the order of ForcePlace::state and ::extra.
  std::vector<std::pair<std::string, Dimension>> states, extra;
};

/// Of the evaluation stack.
inline constexpr int kMaxFormulaDepth = 24;

enum class FormulaCode {
  kNumber,
  kVariable,
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kMax,
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
struct FormulaStep {
  FormulaCode code = FormulaCode::kNumber;
  double number = 0;
  int variable = 0;
  bool free = false;  ///< a coefficient: another number in the next fit
};

inline constexpr Dimension kPlain = {0, 0, 0, 0, 0};
inline constexpr Dimension kNewton = {1, 1, -2, 0};

struct Symbol {
  const char* name;
  Dimension dimension;
};
inline constexpr Symbol kUnits[] = {
    {"m", {1, 0, 0, 0}},    {"s", {0, 0, 1, 0}},      {"K", {0, 0, 0, 1}},   {"kg", {0, 1, 0, 0}},
    {"N", kNewton},         {"Pa", {-1, 1, -2, 0}},   {"Hz", {0, 0, -1, 0}}, {"rad", kPlain},
    {"A", {0, 0, 0, 0, 1}}, {"V", {2, 1, -3, 0, -1}}, {"W", {2, 1, -3, 0}},  {"J", {2, 1, -2, 0}}};
/// In the order of ForcePlace as Force() takes them.
inline constexpr Symbol kVariables[] = {
    {"x", {1, 0, 0, 0}},   {"v", {1, 0, -1, 0}}, {"s", kPlain},        {"p", {-1, 1, -2, 0}},
    {"q", {-1, 1, -2, 0}}, {"t", {0, 0, 1, 0}},  {"dT", {0, 0, 0, 1}}, {"F", kNewton}};
/// Variables of a step: those above, states, further channels.
inline constexpr int kFirstState = 100, kFirstExtra = 200;

inline Dimension Scaled(const Dimension& a, double factor) {
  Dimension out = a;
  for (double& e : out) e *= factor;
  return out;
}
inline Dimension Joined(const Dimension& a, const Dimension& b, double sign) {
  Dimension out = a;
  for (size_t i = 0; i < out.size(); ++i) out[i] += sign * b[i];
  return out;
}

inline double Apply(FormulaCode code, double a, double b) {
  switch (code) {
    case FormulaCode::kAdd:
      return a + b;
    case FormulaCode::kSubtract:
      return a - b;
    case FormulaCode::kMultiply:
      return a * b;
    case FormulaCode::kDivide:
      return a / b;
    case FormulaCode::kMax:
      return std::max(a, b);
    default:
      if (b == 2) return a * a;  // most of them, in a tenth of the time
      if (b == 3) return a * a * a;
      return std::pow(a, b);
  }
}

inline double Apply(FormulaCode code, double a) {
  switch (code) {
    case FormulaCode::kNegate:
      return -a;
    case FormulaCode::kSin:
      return std::sin(a);
    case FormulaCode::kCos:
      return std::cos(a);
    case FormulaCode::kExp:
      return std::exp(a);
    case FormulaCode::kTanh:
      return std::tanh(a);
    case FormulaCode::kAbs:
      return std::abs(a);
    default:
      return std::sqrt(std::max(a, 0.0));
  }
}

}  // namespace phs::effects
