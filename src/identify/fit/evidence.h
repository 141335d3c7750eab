// What speaks for one fitted model over another, from the estimation window alone.
//
//   delta_bic = [-2 ln L(without)] - [-2 ln L(with)] - dk ln N - 2 ln M
// -2 ln L: likelihood.h, the same for every model of a record. dk ln N pays for the numbers
// (Schwarz 1978, Ann. Statist. 6, 461), 2 ln M for having tried M structures to find this one
// (extended BIC: Chen and Chen 2008, Biometrika 95, 759). Cross-validation: parts of the window
// left out in turn, the fit without them by one linear step from the full fit.
#pragma once

#include <string>
#include <vector>

#include "identify/fit/search_fit.h"

namespace phs::identify::search {

struct Evidence {
  double delta_bic = 0;          ///< > 0: better than without it
  double estimation_gain = 0;    ///< share of the residual rms removed, over all channels
  std::string best_channel;      ///< the one whose likelihood gains most
  double best_channel_gain = 0;  ///< share of its residual rms removed
  double share = 0;  ///< removed of what that channel shows beyond its noise [mean square], less
                     ///< what others show more, over what they or it had shown
  double cross_validation_gain = 0;  ///< the same as estimation_gain on parts left out
};

/// `tried`: structures looked at to find `with`.
Evidence Compare(const FitProblem& problem, const FitResult& without, const FitResult& with,
                 double tried);

/// -2 ln L with what k numbers cost: small is good.
double Criterion(const FitProblem& problem, double score, size_t numbers);

}  // namespace phs::identify::search
