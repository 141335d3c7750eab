// A formula beside the listed effects already accepted: whether it says more than that the form of
// one of them is not quite right.
#pragma once

#include <vector>

#include "identify/effect_search.h"

namespace phs::identify::search {

/// Whether a formula is no more than another form of a listed friction effect that is accepted: a
/// force with the direction of motion or over the speed.
bool IsFormOfListedFriction(const FoundFormula& found, const std::vector<AcceptedEffect>& effects);

/// Whether a formula is no more than another form of a listed effect that is accepted: a volume over
/// the pressure of a line, which says how that line yields.
bool IsFormOfListedVolume(const FoundFormula& found, const std::vector<AcceptedEffect>& effects);

/// More than the form of a listed effect not being quite right: much less is left than with the
/// listed effects, or it is said with fewer numbers, the formula's chosen threshold and power
/// counted. `over`: the evidence of the formula over those effects.
bool IsFarBetter(const FitResult& formula, const FitResult& listed, const Evidence& over);

}  // namespace phs::identify::search
