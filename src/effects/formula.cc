#include "effects/formula.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/words.h"

namespace phs::effects {
namespace {

using Step = Formula::Step;
using Code = Formula::Code;

constexpr Dimension kPlain = {0, 0, 0, 0, 0};
constexpr Dimension kNewton = {1, 1, -2, 0};

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

struct Symbol {
  const char* name;
  Dimension dimension;
};
constexpr Symbol kUnits[] = {{"m", {1, 0, 0, 0}},      {"s", {0, 0, 1, 0}},  {"K", {0, 0, 0, 1}},
                             {"kg", {0, 1, 0, 0}},     {"N", kNewton},       {"Pa", {-1, 1, -2, 0}},
                             {"Hz", {0, 0, -1, 0}},    {"rad", kPlain},      {"A", {0, 0, 0, 0, 1}},
                             {"V", {2, 1, -3, 0, -1}}, {"W", {2, 1, -3, 0}}, {"J", {2, 1, -2, 0}}};
// In the order of ForcePlace as Force() takes them.
constexpr Symbol kVariables[] = {{"x", {1, 0, 0, 0}},   {"v", {1, 0, -1, 0}},  {"s", kPlain},
                                 {"p", {-1, 1, -2, 0}}, {"q", {-1, 1, -2, 0}}, {"t", {0, 0, 1, 0}},
                                 {"dT", {0, 0, 0, 1}}};
// Variables of a step: those above, states, further channels.
constexpr int kFirstState = 100, kFirstExtra = 200;
struct Function {
  const char* name;
  Code code;
};
constexpr Function kFunctions[] = {{"sin", Code::kSin}, {"cos", Code::kCos},
                                   {"exp", Code::kExp}, {"tanh", Code::kTanh},
                                   {"abs", Code::kAbs}, {"sqrt", Code::kSqrt}};

Dimension Scaled(const Dimension& a, double factor) {
  Dimension out = a;
  for (double& e : out) e *= factor;
  return out;
}
Dimension Joined(const Dimension& a, const Dimension& b, double sign) {
  Dimension out = a;
  for (size_t i = 0; i < out.size(); ++i) out[i] += sign * b[i];
  return out;
}

double Apply(Code code, double a, double b) {
  switch (code) {
    case Code::kAdd:
      return a + b;
    case Code::kSubtract:
      return a - b;
    case Code::kMultiply:
      return a * b;
    case Code::kDivide:
      return a / b;
    case Code::kMax:
      return std::max(a, b);
    default:
      return std::pow(a, b);
  }
}

double Apply(Code code, double a) {
  switch (code) {
    case Code::kNegate:
      return -a;
    case Code::kSin:
      return std::sin(a);
    case Code::kCos:
      return std::cos(a);
    case Code::kExp:
      return std::exp(a);
    case Code::kTanh:
      return std::tanh(a);
    case Code::kAbs:
      return std::abs(a);
    default:
      return std::sqrt(std::max(a, 0.0));
  }
}

class Parser {
 public:
  Parser(const std::string& text, const FormulaNames& names, const Dimension& whole,
         const std::string& words)
      : text_(text), names_(names), whole_(whole), words_(words) {}

  Result<std::vector<Step>> Parse() {
    const Dimension whole = Sum();
    Skip();
    if (at_ < text_.size()) Fail("unexpected \"" + text_.substr(at_, 8) + "\"");
    if (error_.empty() && whole != whole_) Fail("the whole is no " + words_);
    if (!error_.empty()) {
      return Error{
          "formula \"" + text_ + "\"", error_,
          "x, v, s, p, q, t, dT, " + Known() +
              ", numbers with [unit], + - * / ^, sin, cos, exp, tanh, abs, sqrt, max, pi; a " +
              words_,
          ""};
    }
    return std::move(steps_);
  }

 private:
  /// The further names: a series of coefficients by its ends.
  std::string Known() const {
    if (names_.numbers.contains("c1") && names_.numbers.contains("c6")) return "c1 … c6";
    std::vector<std::string> all;
    for (const auto& [name, number] : names_.numbers) all.push_back(name);
    for (const auto* list : {&names_.states, &names_.extra}) {
      for (const auto& [name, dimension] : *list) all.push_back(name);
    }
    return JoinWords(all);
  }
  void Fail(const std::string& what) {
    if (error_.empty()) error_ = what + " at character " + std::to_string(at_ + 1);
  }
  void Skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  bool Take(char c) {
    Skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void Push(const Step& step) {
    const bool leaf = step.code == Code::kNumber || step.code == Code::kVariable;
    const bool binary = step.code >= Code::kAdd && step.code <= Code::kPower;
    stack_ += leaf ? 1 : binary ? -1 : 0;
    if (stack_ > Formula::kMaxDepth || steps_.size() > 400) Fail("too long");
    steps_.push_back(step);
    FoldFixed(step, leaf, binary);
  }
  /// Follows what is fixed by the text alone: what then has no finite value never will have one.
  void FoldFixed(const Step& step, bool leaf, bool binary) {
    if (!error_.empty()) return;
    if (leaf) {
      fixed_.push_back(step.code == Code::kNumber && !step.free ? std::optional(step.number)
                                                                : std::nullopt);
      return;
    }
    const std::optional<double> b = fixed_.back();
    if (binary) fixed_.pop_back();
    std::optional<double>& a = fixed_.back();
    if (step.code == Code::kDivide && b == 0.0) Fail("a division by zero");
    if (binary) {
      a = a && b ? std::optional(Apply(step.code, *a, *b)) : std::nullopt;
    } else if (a) {
      if (step.code == Code::kSqrt && *a < 0) Fail("a root of a negative number");
      a = Apply(step.code, *a);
    }
    if (a && !std::isfinite(*a)) Fail("a part without finite value");
  }

  Dimension Sum() {
    if (++nested_ > 40) Fail("too many brackets");
    if (!error_.empty()) return kPlain;
    Dimension left = Product();
    while (error_.empty()) {
      const bool plus = Take('+');
      if (!plus && !Take('-')) break;
      if (Product() != left) Fail("a sum of unequal dimensions");
      Push({plus ? Code::kAdd : Code::kSubtract});
    }
    --nested_;
    return left;
  }
  Dimension Product() {
    Dimension left = Signed();
    while (error_.empty()) {
      const bool times = Take('*');
      if (!times && !Take('/')) break;
      left = Joined(left, Signed(), times ? 1 : -1);
      Push({times ? Code::kMultiply : Code::kDivide});
    }
    return left;
  }
  Dimension Signed() {
    int minus = 0;
    while (Take('-')) ++minus;
    const Dimension d = Power();
    if (minus % 2 == 1) Push({Code::kNegate});
    return d;
  }
  Dimension Power() {
    const Dimension base = Atom();
    if (!Take('^')) return base;
    const bool minus = Take('-');
    double exponent = 0;
    if (!Number(&exponent)) Fail("the exponent is no plain number");
    if (minus) exponent = -exponent;
    Push({Code::kNumber, exponent});
    Push({Code::kPower});
    return Scaled(base, exponent);
  }
  bool Number(double* value) {
    Skip();
    const char* begin = text_.c_str() + at_;
    if (at_ >= text_.size() || (!std::isdigit(static_cast<unsigned char>(*begin)) && *begin != '.'))
      return false;
    char* end = nullptr;
    *value = std::strtod(begin, &end);
    at_ += static_cast<size_t>(end - begin);
    return end != begin && std::isfinite(*value);
  }
  std::string Word() {
    Skip();
    const size_t begin = at_;
    while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// [m], [m/s], [N/m], [m^2], [N s/m] …
  Dimension Unit() {
    Dimension out = kPlain;
    double sign = 1;
    while (error_.empty() && !Take(']')) {
      if (Take('/')) {
        sign = -1;
      } else if (!Take('*')) {
        const std::string name = Word();
        const auto* found = std::find_if(std::begin(kUnits), std::end(kUnits),
                                         [&](const Symbol& u) { return name == u.name; });
        if (found == std::end(kUnits)) {
          Fail(name.empty() ? "a unit is not closed" : "unknown unit " + name);
          return out;
        }
        double power = 1;
        if (Take('^') && !Number(&power)) Fail("the exponent of a unit is no number");
        out = Joined(out, found->dimension, sign * power);
      }
    }
    return out;
  }
  Dimension Atom() {
    double value = 0;
    if (Number(&value)) {
      Push({Code::kNumber, value});
      return Take('[') ? Unit() : kPlain;
    }
    if (Take('(')) {
      const Dimension d = Sum();
      if (!Take(')')) Fail("a bracket is not closed");
      return d;
    }
    return Named(Word());
  }
  Dimension Named(const std::string& name) {
    if (name == "pi") {
      Push({Code::kNumber, M_PI});
      return kPlain;
    }
    for (size_t i = 0; i < std::size(kVariables); ++i) {
      if (name != kVariables[i].name) continue;
      Push({Code::kVariable, 0, static_cast<int>(i)});
      return kVariables[i].dimension;
    }
    if (name == "max") return Larger();
    for (const Function& f : kFunctions) {
      if (name != f.name) continue;
      if (!Take('(')) Fail("a bracket is missing");
      const Dimension d = Sum();
      if (!Take(')')) Fail("a bracket is not closed");
      Push({f.code});
      if (f.code == Code::kAbs) return d;
      if (f.code == Code::kSqrt) return Scaled(d, 0.5);
      if (d != kPlain) Fail("the argument of " + name + " has a dimension");
      return kPlain;
    }
    for (const auto& [list, first] :
         {std::pair{&names_.states, kFirstState}, {&names_.extra, kFirstExtra}}) {
      for (size_t i = 0; i < list->size(); ++i) {
        if (name != (*list)[i].first) continue;
        Push({Code::kVariable, 0, first + static_cast<int>(i)});
        return (*list)[i].second;
      }
    }
    const auto found = names_.numbers.find(name);
    if (found == names_.numbers.end()) {
      Fail(name.empty() ? "a value is missing" : "unknown name " + name);
      return kPlain;
    }
    Push({.code = Code::kNumber, .number = found->second.value, .free = true});
    return found->second.dimension;
  }
  Dimension Larger() {
    if (!Take('(')) Fail("a bracket is missing");
    const Dimension d = Sum();
    if (!Take(',')) Fail("max needs two values");
    if (error_.empty() && Sum() != d) Fail("max of unequal dimensions");
    if (!Take(')')) Fail("a bracket is not closed");
    Push({Code::kMax});
    return d;
  }

  const std::string& text_;
  const FormulaNames& names_;
  const Dimension& whole_;
  const std::string& words_;
  std::vector<Step> steps_;
  std::vector<std::optional<double>> fixed_;  ///< the stack, where it depends on nothing
  std::string error_;
  size_t at_ = 0;
  int stack_ = 0, nested_ = 0;
};

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
  Result<std::vector<Step>> steps = Parser(text, names, whole, words).Parse();
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
  for (const Step& step : steps_) {
    if (step.code != Code::kVariable || step.variable >= kFirstState) continue;
    const std::string name = kVariables[step.variable].name;
    if (allowed.find(name) == std::string::npos) return name;
  }
  return {};
}

double Formula::Value(const hydraulics::ForcePlace& place) const noexcept {
  const double variables[] = {place.piston,   place.speed, place.direction,  place.bore_rise,
                              place.rod_rise, place.time,  place.temperature};
  double stack[kMaxDepth + 1];
  int top = -1;
  for (const Step& step : steps_) {
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
}

}  // namespace phs::effects
