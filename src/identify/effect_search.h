// From measured data to a corrected model: baseline, search over the catalogue, choice.
//
// Search. Candidates are screened and fitted on a coarse record, the best few fitted in full
// (screening.h). Forward selection, then a backward pass that drops what the later effects made
// superfluous, and an exchange pass that tries to replace one accepted effect by another so that a
// wrong first choice can be undone. Evidence: evidence.h. The validation window is not looked at.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "identify/effect_variants.h"
#include "identify/evidence.h"
#include "identify/formula_search.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

struct CandidateRecord {
  std::string effect;
  std::string variant;  ///< targets and free numbers
  int round = 0;
  double screening_gain = 0;
  double coarse_gain = 0;  ///< after a fit on the coarse record
  bool fitted = false;
  Evidence evidence;
  std::string verdict;  ///< "accepted", or why not
};

struct AcceptedEffect {
  Candidate candidate;
  Evidence evidence;
  std::vector<std::string> confusable_with;
};

struct SearchOptions {
  int threads = 2;
  int max_effects = 3;
  double coarse_step_s = 0.02;      ///< clock of the coarse record
  int coarse_fits = 16;             ///< variants fitted on the coarse record per round
  int full_fits = 4;                ///< effects fitted in full per round
  double min_delta_bic = 12;        ///< in units of 2 ln(likelihood)
  double min_gain = 0.012;          ///< of the pooled residual rms …
  double min_channel_gain = 0.03;   ///< … or of one channel
  double min_first_removed = 0.3;   ///< of what exceeds the noise, by the first effect
  double min_excess_removed = 0.4;  ///< of a second effect: share of what exceeds the noise
  /// A formula beside listed effects must take this much of the load cell's residual rms: less may
  /// be no more than the form of the listed ones not being quite right.
  double min_formula_gain = 0.4;
  bool formula = true;   ///< what no effect explains is described
  bool thorough = true;  ///< the first round judges every start by a short fit (fast models)
  double margin = 0.02;  ///< residual rms within this: cannot be told apart
};

struct Identification {
  FreeModel declared, corrected;
  FitResult before, after;
  std::vector<AcceptedEffect> effects;  ///< strongest first
  FoundFormula formula;                 ///< of the effect `unlisted`, if accepted
  std::vector<CandidateRecord> candidates;
  bool cancelled = false;
};

/// Progress from 0 to 1; false cancels.
using Progress = std::function<bool(double)>;

Result<Identification> Identify(FitProblem* problem, const hydraulics::PhsParams& declared,
                                const SearchOptions& options, const Progress& progress);

}  // namespace phs::identify::search
