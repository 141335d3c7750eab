// A formula beside listed effects that is the form of one of them.
//
// Where a record shows an effect in a shape that its law does not have, the law takes most and a
// formula the rest. Such a formula is no second cause: it acts where the effect acts and is over no
// other variables than its law (hydraulics::LawOver). It is said as the form of the effect. Where
// several laws are over its variables, the effect must weigh more than the formula: the formula might
// be another one. A friction over the position is of one law alone.
#pragma once

#include <cstddef>
#include <optional>

#include "identify/select/identification.h"

namespace phs::identify::search {

/// True of the effect `unlisted`.
bool IsFormula(const AcceptedEffect& effect);

/// Of the effects of `found` the strongest one whose form the formula is. Nothing: no formula, or one
/// with a cause of its own.
std::optional<size_t> HasOwnForm(const Identification& found);

}  // namespace phs::identify::search
