// The words of a formula and what they do: units, variables, operators. Parser and evaluation share
// them, so that what is folded while reading is what would come out in a run.
#pragma once

#include <algorithm>
#include <cmath>

#include "effects/formula.h"

namespace phs::effects {

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
    {"x", {1, 0, 0, 0}},   {"v", {1, 0, -1, 0}}, {"s", kPlain},       {"p", {-1, 1, -2, 0}},
    {"q", {-1, 1, -2, 0}}, {"t", {0, 0, 1, 0}},  {"dT", {0, 0, 0, 1}}};
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

inline double Apply(Formula::Code code, double a, double b) {
  switch (code) {
    case Formula::Code::kAdd:
      return a + b;
    case Formula::Code::kSubtract:
      return a - b;
    case Formula::Code::kMultiply:
      return a * b;
    case Formula::Code::kDivide:
      return a / b;
    case Formula::Code::kMax:
      return std::max(a, b);
    default:
      return std::pow(a, b);
  }
}

inline double Apply(Formula::Code code, double a) {
  switch (code) {
    case Formula::Code::kNegate:
      return -a;
    case Formula::Code::kSin:
      return std::sin(a);
    case Formula::Code::kCos:
      return std::cos(a);
    case Formula::Code::kExp:
      return std::exp(a);
    case Formula::Code::kTanh:
      return std::tanh(a);
    case Formula::Code::kAbs:
      return std::abs(a);
    default:
      return std::sqrt(std::max(a, 0.0));
  }
}

}  // namespace phs::effects
