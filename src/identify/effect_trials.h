// Effects tried on top of a model: screened on the coarse record, the best fitted in full.
#pragma once

#include <functional>
#include <vector>

#include "identify/effect_variants.h"
#include "identify/screening.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

/// A screened candidate and, for the best, its form with options and its fit to the whole record.
struct FullTrial : Trial {
  Candidate form;
  FitResult fit;
};

struct TrialOptions {
  int coarse_fits = 16;   ///< variants fitted on the coarse record
  int full_fits = 4;      ///< variants fitted in full …
  int each = 1;           ///< … at most so many of one effect
  bool elsewhere = true;  ///< tried away from the best fit too (fast models)
  bool thorough = true;   ///< every start is judged by a short fit
  size_t declared = 0;    ///< so many of the model's numbers are the declared model's own
  /// Only those whose mean log square on the coarse record is below this are fitted in full.
  double most_coarse = 1e300;
  /// The same on the whole record after the first step there.
  double most_full = 1e300;
  /// Where candidates are tried, if not where the above would; of several the last by hydraulic
  /// ones only.
  std::vector<std::vector<double>> points = {};
};

/// Screens `list` on top of `model` as fitted by `fit` and fits the best `full_fits` in full.
/// `tick(share)`: progress from 0 to 0.3, false = stop. `reference`: mean log square of the model
/// alone on the coarse record. Candidates of `list` must outlive the result.
std::vector<FullTrial> TryEffects(const FitProblem& problem, const FitProblem& coarse,
                                  const FreeModel& model, const FitResult& fit,
                                  const std::vector<Candidate>& list, const TrialOptions& options,
                                  const std::function<bool(double)>& tick, double* reference);

/// Options of a trial's form that the whole record asks for and the coarse one did not.
void ShapeOnWhole(const FitProblem& problem, const FreeModel& model, FullTrial* trial);

/// What rivals of an accepted model may leave on the coarse record to be worth a full fit [mean log
/// square]: what it leaves there itself, and what shaping a form may still bring.
double MostOfRivals(const FitProblem& coarse, const FreeModel& model,
                    const std::vector<double>& values);

}  // namespace phs::identify::search
