// Formulas among the effects: one that says more than all listed effects accepted takes their
// place, one for what these leave stands beside them.
#pragma once

#include "identify/identification.h"

namespace phs::identify::search {

/// No listed effect is bent to stand for what is on no list: where a formula of one term says more
/// than all the effects accepted, they go.
void ChallengeByFormula(const FitProblem& problem, const FitProblem& coarse, Identification* found);

/// A formula for what the accepted model still leaves. True if it was added.
bool AddFormula(const FitProblem& problem, const FitProblem& coarse, Identification* found);

}  // namespace phs::identify::search
