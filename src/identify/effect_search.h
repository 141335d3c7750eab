// From measured data to a corrected model: baseline, search over the catalogue, choice.
//
// Search. Of every candidate variant, from every start, one Gauss–Newton step of the free numbers
// of the current model (their derivatives taken once) and of the candidate's own is predicted; the
// most promising variants are fitted in full. Forward selection, then a backward pass that drops
// what the later effects made superfluous, and an exchange pass that tries to replace one accepted
// effect by another so that a wrong first choice can be undone.
//
// Evidence. Per channel the residual variance s² is unknown and samples are correlated:
//   BIC = sum_c n_eff,c ln s²_c + k ln(sum_c n_eff,c),  n_eff from the residual's autocorrelation
// (the same n_eff for the models compared: of the better one). Gain of estimation: 1 - rms/rms of
// the best channel. Cross-validation: blocks of the estimation window left out in turn, the fit
// without them by one linear step from the full fit. The validation window is not looked at.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/result.h"
#include "identify/effect_variants.h"
#include "identify/search_fit.h"

namespace phs::identify::search {

struct Evidence {
  double delta_bic = 0;          ///< > 0: better than without it
  double estimation_gain = 0;    ///< share of the residual rms removed, over all channels
  double best_channel_gain = 0;  ///< the same of the channel that gains most
  std::string best_channel;
  double cross_validation_gain = 0;
};

struct CandidateRecord {
  std::string effect;
  std::string variant;  ///< targets and free numbers
  int round = 0;
  double screening_gain = 0;
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
  int full_fits = 7;               ///< variants fitted in full per round
  double min_delta_bic = 12;       ///< in units of 2 ln(likelihood)
  double min_gain = 0.012;         ///< of the pooled residual rms …
  double min_channel_gain = 0.03;  ///< … or of one channel
  double margin = 0.02;            ///< residual rms within this: cannot be told apart
};

struct Identification {
  FreeModel declared, corrected;
  FitResult before, after;
  std::vector<AcceptedEffect> effects;  ///< strongest first
  std::vector<CandidateRecord> candidates;
  bool cancelled = false;
};

/// Progress from 0 to 1; false cancels.
using Progress = std::function<bool(double)>;

Evidence Compare(const FitProblem& problem, const FitResult& without, const FitResult& with);

Result<Identification> Identify(FitProblem* problem, const hydraulics::PhsParams& declared,
                                const SearchOptions& options, const Progress& progress);

}  // namespace phs::identify::search
