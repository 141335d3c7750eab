// What explains as much as an effect that is accepted.
#pragma once

#include "identify/select/identification.h"
#include "identify/select/trials.h"

namespace phs::identify::search {

/// A trial as an accepted effect; what of the others that pass the rule themselves chance may have
/// put behind it is noted.
AcceptedEffect BesideRivals(const FitProblem& problem, const FullTrial& trial,
                            const Evidence& evidence, const std::vector<FullTrial>& others);

}  // namespace phs::identify::search
