#include "effects/formula.h"

#include <algorithm>
#include <cmath>

#include "effects/formula_parser.h"
#include "effects/formula_words.h"

namespace phs::effects {
namespace {

using Code = FormulaCode;

/// What a formula may give: its dimension, its suffix, and in words.
struct Kind {
  Dimension dimension;
  const char* suffix;
  const char* words;
};
constexpr Kind kKinds[] = {{kNewton, "N", "force [N]"},
                           {{3, 0, 0, 0}, "m3", "volume [m^3]"},
                           {{3, 0, -1, 0}, "m3_per_s", "flow [m^3/s]"},
                           {{1, 0, 0, 0}, "m", "length [m]"},
                           {{-1, 1, -2, 0}, "Pa", "pressure [Pa]"}};

}  // namespace

const char* UnitSuffix(FormulaUnit unit) { return kKinds[static_cast<int>(unit)].suffix; }

Result<Formula> Formula::Parse(const std::string& text,
                               const std::map<std::string, double>& coefficients,
                               FormulaUnit unit) {
  const Kind& kind = kKinds[static_cast<int>(unit)];
  FormulaNames names;
  for (const auto& [name, value] : coefficients) names.numbers[name] = {value, kind.dimension};
  return Parse(text, names, kind.dimension, kind.words);
}

Result<Formula> Formula::Parse(const std::string& text, const FormulaNames& names,
                               const Dimension& whole, const std::string& words) {
  Result<std::vector<FormulaStep>> steps = ParseFormula(text, names, whole, words);
  if (!steps.ok()) return steps.error();
  return Formula(std::move(steps.value()));
}

Result<Dimension> DimensionOf(const std::string& ending) {
  Dimension out = kPlain;
  double sign = 1;
  for (size_t at = 0; at < ending.size();) {
    if (ending.compare(at, 5, "_per_") == 0) {
      sign = -1, at += 5;
    } else if (ending.compare(at, 4, "per_") == 0 && at == 0) {
      sign = -1, at += 4;
    } else if (ending[at] == '_') {
      sign = -1, ++at;  // m_s: metres per second
    } else if (ending[at] == '1') {
      ++at;
    } else {
      const Symbol* longest = nullptr;
      for (const Symbol& unit : kUnits) {
        const size_t length = std::string(unit.name).size();
        const bool fits = ending.compare(at, length, unit.name) == 0;
        if (fits && (longest == nullptr || length > std::string(longest->name).size())) {
          longest = &unit;
        }
      }
      if (longest == nullptr) {
        return Error{ending, "is no unit",
                     "units in a row, over others: N, N_per_m, Ns_per_m, m3_per_s, m_s, V", ""};
      }
      at += std::string(longest->name).size();
      double power = 1;
      if (at < ending.size() && ending[at] >= '2' && ending[at] <= '9') power = ending[at++] - '0';
      out = Joined(out, longest->dimension, sign * power);
    }
  }
  return out;
}

std::string Formula::VariableOtherThan(const std::string& allowed) const {
  for (const FormulaStep& step : steps_) {
    if (step.code != Code::kVariable || step.variable >= kFirstState) continue;
    std::string name = kVariables[step.variable].name;
    if (allowed.find(name) == std::string::npos) return name;
  }
  return {};
}

bool Formula::Uses(const std::string& variable) const {
  return std::any_of(steps_.begin(), steps_.end(), [&](const FormulaStep& step) {
    return step.code == Code::kVariable && step.variable < kFirstState &&
           kVariables[step.variable].name == variable;
  });
}

double Formula::Value(const hydraulics::ForcePlace& place) const noexcept {
  const double variables[] = {place.piston,   place.speed, place.direction,   place.bore_rise,
                              place.rod_rise, place.time,  place.temperature, place.force};
  double stack[kMaxFormulaDepth + 1];
  int top = -1;
  // NOLINTBEGIN(clang-analyzer-core.CallAndMessage): a parsed formula takes nothing from an empty stack
  for (const FormulaStep& step : steps_) {
    if (step.code == Code::kNumber) {
      stack[++top] = step.number;
    } else if (step.code == Code::kVariable) {
      stack[++top] = step.variable < kFirstState ? variables[step.variable]
                     : step.variable < kFirstExtra
                         ? (place.state != nullptr ? place.state[step.variable - kFirstState] : 0)
                         : (place.extra != nullptr ? place.extra[step.variable - kFirstExtra] : 0);
    } else if (step.code <= Code::kPower) {
      --top;
      stack[top] = Apply(step.code, stack[top], stack[top + 1]);
    } else {
      stack[top] = Apply(step.code, stack[top]);
    }
  }
  return std::isfinite(stack[0]) ? stack[0] : 0.0;
  // NOLINTEND(clang-analyzer-core.CallAndMessage)
}

}  // namespace phs::effects
