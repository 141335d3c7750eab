// Samples weighed by the accepted model. An effect may be far more sensitive to what is uncertain
// of the motion than the model without it: a stiff bristle, where the piston rests.
#pragma once

#include "identify/effect_search.h"

namespace phs::identify::search {

/// Weights of both problems by `found->corrected`, if they differ by more than a tenth from those
/// at hand in the mean square of a channel; then declared and corrected model are fitted anew. If
/// either cannot be, all stays as it was.
void Reweigh(FitProblem* problem, FitProblem* coarse, Identification* found);

}  // namespace phs::identify::search
