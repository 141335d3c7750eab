// Looking through many candidates with few runs of the model, on a coarse record (about 50 Hz).
//
// Every variant of every effect, from each of its starts, about each point, is judged by one
// predicted Gauss–Newton step of all numbers together. Amounts that are far off by the share of
// what they do that the record asks for are moved there before, so that the shape of what an effect
// does decides, not its start. The best starts by that promise and the best as it stands take a
// few steps really, and the best of them as many more: below its onset a stop or a valve is silent, and no
// slope leads to it; beyond, it says less than nothing until the model's numbers have come back. The
// most promising variants are then fitted to the coarse record.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "identify/fit/effect_variants.h"
#include "identify/fit/search_fit.h"
#include "identify/select/known_answers.h"

namespace phs::identify::search {

/// Where candidates are tried: numbers of the model, fitted to the coarse record.
using Point = FitResult;

struct Trial {
  const Candidate* candidate = nullptr;
  double promise = 1e300;  ///< criterion after the steps of screening, small = good
  FitResult coarse;        ///< ok for the most promising: fit to the coarse record
  bool fails = false;      ///< the model cannot be run with it from any of its starts
};

/// How much work a search may do. None of it decides what is accepted of what was tried.
struct Effort {
  int threads = 2;
  int max_effects = 3;
  double coarse_step_s = 0.02;  ///< clock of the coarse record
  int stepped = 32;             ///< variants that take steps really, per round
  int coarse_fits = 16;         ///< of these fitted to the coarse record
  int full_fits = 4;            ///< effects fitted to the whole one
  int starts = 3;               ///< of a variant, from which steps are really taken
  int steps = 6;                ///< so many at most
  int option_fits = 0;          ///< further numbers fitted of a form, after a step of each; 0: all
  bool elsewhere = true;        ///< candidates are tried away from the best fit too
  bool unpromising = false;     ///< what promises not to pay is tried and finished, too
};

/// Judges `list` on top of `model` about each of `points`. `go_on(share)`: progress, false = stop.
/// Best first; those with a coarse fit before those without, and what fails at the end. Candidates
/// must outlive the result. `known`: of earlier rounds on this problem, added to; may be null.
std::vector<Trial> ScreenCandidates(const FitProblem& coarse, const FreeModel& model,
                                    const std::vector<Point>& points,
                                    const std::vector<Candidate>& list, const Effort& effort,
                                    const std::function<bool(double)>& go_on,
                                    KnownAnswers* known = nullptr);

}  // namespace phs::identify::search
