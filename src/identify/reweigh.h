// New weights of the samples from the accepted model.
//
// The measured motion has noise; how much of it reaches an output depends on the model. A stiff
// bristle on a piston at rest turns 1 um into newtons, the declared model does not. So the weight of
// a sample, one over its uncertainty, is worked out anew once effects are accepted.
#pragma once

#include "identify/effect_search.h"

namespace phs::identify::search {

/// Gives both problems the weights of `found->corrected` and fits the declared and the corrected
/// model anew. Nothing happens where the weights differ by less than a tenth in the mean square of
/// every channel, or where one of the fits fails. The evidence of the effects stays as it was when
/// they were chosen.
void Reweigh(FitProblem* problem, FitProblem* coarse, Identification* found);

}  // namespace phs::identify::search
