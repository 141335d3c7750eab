// A formula beside the listed effects already accepted: whether it says more than that the form of
// one of them is not quite right.
#pragma once

#include <vector>

#include "identify/effect_search.h"

namespace phs::identify::search {

/// A force with the direction or over the speed is friction: beside or instead of a listed
/// friction effect it is no more than the form of that.
bool IsTheirFriction(const FoundFormula& found, const std::vector<AcceptedEffect>& effects);

/// A volume over the pressure of a line says how that line yields: so do some listed effects.
bool IsTheirVolume(const FoundFormula& found, const std::vector<AcceptedEffect>& effects);

/// More than the form of a listed effect not being quite right: much less is left than with the
/// listed effects, or it is said with fewer numbers, the formula's chosen threshold and power
/// counted. `over`: the evidence of the formula over those effects.
bool IsFarBetter(const FitResult& formula, const FitResult& listed, const Evidence& over);

}  // namespace phs::identify::search
