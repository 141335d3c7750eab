// Formulas among the effects: one that says more than all listed effects accepted takes their
// place, one for what these leave stands beside them.
#pragma once

#include <functional>

#include "identify/select/identification.h"
#include "identify/select/screening.h"

namespace phs::identify::search {

/// No listed effect is bent to stand for what is on no list: where a formula of one term says more
/// than all the effects accepted, beyond chance, they go; so they do, where a sensor's fault is among
/// them, for a force or a law of a line of several terms. It gets a name where a listed
/// effect explains as much (listed_name.h). Where it is another form of one of them (own_form.h), that
/// one stays, with a formula for what its law leaves if the two say as much.
void ChallengeByFormula(const FitProblem& problem, const FitProblem& coarse, const Effort& effort,
                        const std::function<bool(double)>& go_on, Identification* found);

/// A formula for what the accepted model still leaves, or the listed effect that it is. True if one
/// was added.
bool AddFormula(const FitProblem& problem, const FitProblem& coarse, const Effort& effort,
                const std::function<bool(double)>& go_on, Identification* found);

}  // namespace phs::identify::search
