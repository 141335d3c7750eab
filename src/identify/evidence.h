// What speaks for one fitted model over another, from the estimation window alone.
//
// Per channel the residual variance s² is unknown and samples are correlated. Two criteria:
//   correlated  BIC = sum_c n_eff,c ln s²_c + k ln(sum_c n_eff,c), n_eff from the autocorrelation
//               of the residual of the better of the two models compared;
//   whitened    BIC = sum_c N ln w²_c + k ln(sum_c N), w² the variance of the innovations of an
//               autoregression of each residual.
// The first sees slow effects (drift, heat), the second an effect of fast events on top of a slow
// misfit that is still to be explained. Evidence is the stronger of the two. Cross-validation:
// blocks of the estimation window left out in turn, the fit without them by one linear step from
// the full fit.
#pragma once

#include <string>
#include <vector>

#include "identify/search_fit.h"

namespace phs::identify::search {

struct Evidence {
  double delta_bic = 0;  ///< > 0: better than without it; the larger of the next two
  double correlated_bic = 0, whitened_bic = 0;
  double estimation_gain = 0;    ///< share of the residual rms removed, over all channels
  double best_channel_gain = 0;  ///< the same of the channel that gains most
  std::string best_channel;
  double best_channel_left = 0;  ///< mean square it is left with, over that of noise and input
  double cross_validation_gain = 0;
  /// Share of the mean square beyond the noise that went, over all channels (1:
  /// all of it).
  double excess_removed = 0;
  /// The same of one pressure, the largest, or what held-out blocks say of it if that is less; 0
  /// where that takes less than 3 % of its residual. The pressures of one driven cylinder know
  /// nothing of friction, whose laws are never quite right: what exceeds their noise was made by
  /// something else. (Not so on the full rig, whose beam yields to friction.)
  double pressure_removed = 0;
  bool settled = true;  ///< the amounts of what came in are told by the record
};

Evidence Compare(const FitProblem& problem, const FitResult& without, const FitResult& with);

/// Mean over channels of ln(mean square): what ranking rests on.
double MeanLogSquare(const Eigen::VectorXd& residual, int channels);

}  // namespace phs::identify::search
