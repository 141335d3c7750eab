// Where candidates are tried: a missing effect may have bent the fit of the model so far that the
// effect's own numbers have no way back from there.
#pragma once

#include <vector>

#include "identify/select/screening.h"

namespace phs::identify::search {

/// On the coarse record: the best fit; `elsewhere`: a robust one, and for each declared number that
/// the fit has moved by a tenth from its declared value the fit of the others with that one held there.
/// `fit`: of `model`, whose first `declared` numbers are those of the declared model. Empty if the
/// model cannot be run.
std::vector<Point> PointsAbout(const FitProblem& coarse, const FreeModel& model,
                               const FitResult& fit, size_t declared, bool elsewhere);

}  // namespace phs::identify::search
