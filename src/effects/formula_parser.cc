#include "effects/formula_parser.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/words.h"
#include "effects/formula_words.h"

namespace phs::effects {
namespace {

using Step = FormulaStep;
using Code = FormulaCode;

struct Function {
  const char* name;
  Code code;
};
constexpr Function kFunctions[] = {{"sin", Code::kSin}, {"cos", Code::kCos},
                                   {"exp", Code::kExp}, {"tanh", Code::kTanh},
                                   {"abs", Code::kAbs}, {"sqrt", Code::kSqrt}};

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
          "x, v, s, p, q, t, dT, F, " + Known() +
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
    if (stack_ > kMaxFormulaDepth || steps_.size() > 400) Fail("too long");
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
  /// A name of the law's own goes before a variable: it may be called F.
  bool IsOwn(const std::string& name) const {
    const auto is_it = [&](const auto& named) { return named.first == name; };
    return names_.numbers.contains(name) ||
           std::any_of(names_.states.begin(), names_.states.end(), is_it) ||
           std::any_of(names_.extra.begin(), names_.extra.end(), is_it);
  }
  Dimension Named(const std::string& name) {
    if (name == "pi") {
      Push({Code::kNumber, M_PI});
      return kPlain;
    }
    for (size_t i = 0; !IsOwn(name) && i < std::size(kVariables); ++i) {
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
        if (name.empty() || name != (*list)[i].first) continue;
        Push({Code::kVariable, 0, first + static_cast<int>(i)});
        return (*list)[i].second;
      }
    }
    const auto number = names_.numbers.find(name);
    if (number == names_.numbers.end()) {
      Fail(name.empty() ? "a value is missing" : "unknown name " + name);
      return kPlain;
    }
    Push({.code = Code::kNumber, .number = number->second.value, .free = true});
    return number->second.dimension;
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

Result<std::vector<Step>> ParseFormula(const std::string& text, const FormulaNames& names,
                                       const Dimension& whole, const std::string& words) {
  return Parser(text, names, whole, words).Parse();
}

}  // namespace phs::effects
