// On a rig of several cylinders: which of the effects of one cylinder alone are worth a trial.
#pragma once

#include <vector>

#include "identify/effect_variants.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

/// Of candidates that show at their place keeps those of the cylinder whose load cell leaves most
/// over its noise; none where all load cells are at their noise. Others stay.
void KeepWorstPlace(const FitProblem& problem, const FitResult& fit,
                    const hydraulics::PhsParams& params, std::vector<Candidate>* candidates);

}  // namespace phs::identify::search
