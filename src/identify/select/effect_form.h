// The form of a candidate: further numbers of the same effect, freed one set by one while the
// record asks for them.
#pragma once

#include "identify/fit/effect_variants.h"
#include "identify/fit/search_fit.h"
#include "identify/select/screening.h"

namespace phs::identify::search {

/// Frees options of `form` (fitted as `now` on top of `model`) as long as the best of them passes
/// the rule of acceptance (acceptance.h) among all that were tried. Gives the fit.
FitResult AddOptions(const FitProblem& problem, const FreeModel& model, FitResult now,
                     Candidate* form, const Effort& effort);

/// Takes options out of `form` (fitted as `now`) that are idle, or that later ones have made idle:
/// without each of them chance alone would leave as much. The first `core` numbers stay.
void DropIdle(const FitProblem& problem, const FreeModel& model, size_t core, Candidate* form,
              FitResult* now);

/// Takes the options out of `form` that ended at an end of their range in `fit`, the fit on top of
/// `model` to the whole record, and fits what is left: a number on its bound says that the form is
/// not this one. The first `core` numbers of the form stay.
void DropEdges(const FitProblem& problem, const FreeModel& model, size_t core, Candidate* form,
               FitResult* fit);

}  // namespace phs::identify::search
