// The form of an effect: which of its options the data ask for.
//
// One effect comes in several physical forms (a leak through a gap or an orifice, a hose that
// stiffens or creeps, a resistance linear or quadratic in flow). The catalogue holds them as
// further numbers of the effect; each is freed only if the coarse record asks for it, the one that
// explains most first.
#pragma once

#include "identify/effect_variants.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

/// Frees options of `form`, fitted as `now` with all columns of the Jacobian, one by one. Returns
/// the fit of the form that results.
FitResult AddOptions(const FitProblem& problem, const FreeModel& model, FitResult now,
                     Candidate* form);

/// The same of a form fitted on the coarse record on top of `model` as `fit`, which is
/// settled first.
FitResult ShapeForm(const FitProblem& coarse, const FreeModel& model, const FitResult& fit,
                    Candidate* form);

}  // namespace phs::identify::search
