// What the catalogue does not hold, on a rig with one cylinder: a force over direction, speed,
// place, pressures and time (formula_search.h), sought in the residual of the load cell and added
// as the effect `unlisted`.
#pragma once

#include "identify/effect_variants.h"
#include "identify/formula_search.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

/// The formula that the load cell's residual of this fit asks for; empty if none, or if the rig has
/// no such channel or more than one cylinder.
FoundFormula SearchForceFormula(const FitProblem& problem, const FreeModel& model,
                                const FitResult& fit, const FormulaLimits& limits);

/// The formula as an effect whose coefficients are free; bounds: `most` [N] to either side.
Candidate FormulaCandidate(const FoundFormula& found, double most);

}  // namespace phs::identify::search
