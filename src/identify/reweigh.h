// Samples weighed by the accepted model. An effect may be far more sensitive to what is uncertain
// of the motion than the model without it: a stiff bristle, where the piston rests.
#pragma once

#include "identify/effect_search.h"

namespace phs::identify::search {

/// Weights of both problems by `found->corrected`, if by one of the two, that and that at hand, the
/// other's noise were off by more than a tenth in the mean square of a channel; then declared and
/// corrected model are fitted anew. If either cannot be, all stays as it was. The evidence of an
/// effect remains that of the choice.
void Reweigh(FitProblem* problem, FitProblem* coarse, Identification* found);

}  // namespace phs::identify::search
