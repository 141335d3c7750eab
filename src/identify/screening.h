// Looking through many candidates with few runs of the model.
//
// On a coarse record (about 50 Hz) every variant of every effect, from each of its starts, is
// judged by one predicted Gauss–Newton step of all numbers together (on the declared model, effects
// with an onset by short fits from the best of their starts); the promising are fitted on
// the coarse record, and the best of these are then fitted to the whole record by the search.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identify/effect_variants.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

struct Trial {
  const Candidate* candidate = nullptr;
  size_t point = 0;             ///< the point it starts from
  std::vector<double> start;    ///< of all numbers of the extended model
  double predicted = 1e300;     ///< predicted mean log square
  double square = 1e300;        ///< predicted weighted sum of squares, what a fit minimises
  FitResult coarse;             ///< if it was promising
  double coarse_score = 1e300;  ///< n_eff-weighted criterion of the coarse fit, small = good
};

struct ScreeningOptions {
  int coarse_fits = 16;
  bool thorough = false;  ///< judge effects with an onset by short fits, not by a predicted step
  /// Points from here on are tried by hydraulic effects only.
  size_t hydraulic_from = 1000;
};

/// Judges `list` on top of `model` at each of `points` (values of its free numbers; the first is
/// its best fit). `tick(share)`: progress, false = stop. Best first; those with a coarse fit before
/// those without. `reference`: mean log square of the model alone, refitted on the coarse record.
std::vector<Trial> ScreenCandidates(const FitProblem& coarse, const FreeModel& model,
                                    const std::vector<std::vector<double>>& points,
                                    const std::vector<Candidate>& list,
                                    const ScreeningOptions& options,
                                    const std::function<bool(double)>& tick, double* reference);

}  // namespace phs::identify::search
