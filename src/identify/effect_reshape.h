// Accepted effects tried anew beside each other.
//
// An effect takes its form, and the model's own numbers their place, while another is still
// missing: a hose on one line only, beside a bush that was bent to stand for part of it; a warming
// that comes back for one that settles. Once both are there, each is tried anew in all its forms.
#pragma once

#include <functional>
#include <vector>

#include "identify/effect_search.h"

namespace phs::identify::search {

/// Values of the accepted effects' model but one effect, as in `found.after`, and that model.
std::vector<double> ValuesWithout(const Identification& found, size_t dropped, FreeModel* model);

/// The model of the accepted effects but one, fitted.
FitResult FitWithout(const FitProblem& problem, const Identification& found, size_t dropped,
                     FreeModel* model);

/// Whether `simple` has fewer numbers than `other` and fits as well: the other lowers the rms of the
/// residual by less than 0.5 % in all and less than 1 % in each channel, times `margin`.
bool FitsAsWellWithFewer(const FitProblem& problem, const FitResult& simple, const FitResult& other,
                         double margin = 1);

/// Tries each accepted effect of `found` in all its forms, from where the numbers are now and (the
/// hydraulic ones) from the declared volumes, and as the simpler effect that it contains. Takes
/// what explains more, or as much with fewer numbers, until none gains more than 1 % or each has
/// been looked at twice. The effects keep their order. `tick`: false = stop. Evidence is left to
/// the search, which weighs each against the others at its end.
void ReshapeEffects(const FitProblem& problem, const FitProblem& coarse,
                    const SearchOptions& options, const std::function<bool(double)>& tick,
                    Identification* found);

}  // namespace phs::identify::search
