// Text of a formula to its reverse Polish form (formula.h says what may stand there).
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "effects/formula_words.h"

namespace phs::effects {

/// Steps of `text`. Errors: syntax, unknown names, dimensions (`whole`, in words `words`), depth, a
/// part that never has a finite value.
Result<std::vector<FormulaStep>> ParseFormula(const std::string& text, const FormulaNames& names,
                                              const Dimension& whole, const std::string& words);

}  // namespace phs::effects
