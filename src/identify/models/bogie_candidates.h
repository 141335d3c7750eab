// The effects that a bogie on its track is searched for: those of the PHS that show in a curve, and
// those of wheel and track, as their rows say. A run costs a tenth of a second, so there are fewer
// variants and starts than on a rig. Instruments are not among them: a bogie's prediction has none.
#pragma once

#include <string>
#include <vector>

#include "identify/fit/effect_variants.h"
#include "vehicle/running_effects.h"

namespace phs::identify::search {

/// All candidates that are not in `params` yet, beside the `free` numbers of the declared model.
std::vector<Candidate> ListBogieCandidates(const hydraulics::PhsParams& params,
                                           const std::vector<std::string>& free,
                                           const vehicle::DeclaredRunning& declared);
/// Their effects, each once.
std::vector<std::string> BogieCandidateNames();

}  // namespace phs::identify::search
