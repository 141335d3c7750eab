// On a rig of several cylinders: which of the effects of one cylinder alone are worth a trial.
//
// The load cell that leaves most need not be the one where something is missing: a number common to
// all cylinders (the scale of friction) is fitted to all, and spreads what one of them shows. So the
// place is asked of the simplest effects that stand there, those of a single number a. With r the
// coefficients of the residual of the best fit over their deviation, d = dr/da where a does nothing,
// and d' what of d the other free numbers cannot do, a takes (d' r)^2/(d' d') of -2 ln L to first
// order (Rao's score test, 1948).
#pragma once

#include <vector>

#include "identify/fit/effect_variants.h"
#include "identify/fit/search_fit.h"

namespace phs::identify::search {

/// Of candidates that show at their place keeps, of each family of effects, those of the cylinder
/// where one number of that family takes most (of a family that has no such number, of the one whose
/// load cell leaves most over its noise); none where all load cells are at their noise. Others stay.
/// `fit`: of `model`, with the slopes of all its numbers.
void KeepWorstPlace(const FitProblem& problem, const FreeModel& model, const FitResult& fit,
                    std::vector<Candidate>* candidates);

}  // namespace phs::identify::search
