// What a motion that nobody has made yet would say between two fitted models.
//
// Let A be the truth. On the motion it answers y_A; the other, B, is refitted to that with all its
// free numbers inside their bounds, and what it cannot take up is the residual r. Over the noise of
// the record, r has the power D_b in octave b (likelihood.h); noise and discrepancy of the record
// have N_b >= 1 there, as A leaves them. What B leaves is N + D, so the likelihood, whose m and S
// are those of the rule of acceptance, is expected to favour A by
//   E = sum_b m_b [ln S(N+D) + (N+D)/S(N+D) - ln S(N) - N/S(N)]
// It scatters (delta method): the noise along r by 4 D N/m, and the noise's own level, known to
// 2/m, by 2 (D + N)²/m less that which A shares, each through dE/dD = m/(N + D):
//   V = sum_b m_b [4 D N + 2 D²]/(N + D)²
// For a small D these are the mean δ² and the variance 4 δ² of a likelihood ratio between two known
// means. A is named and B ruled out where E + (k_B - k_A) ln N_samples > -2 ln(false_alarms), the
// rule of acceptance (accept.h): with the probability Φ of the distance over the root of V.
//
// Left out: the amounts of A are taken as fitted, and the motion's own uncertainty as its mean over
// the record.
#pragma once

#include <string>
#include <vector>

#include "identify/fit/search_fit.h"

namespace phs::identify::search {

/// A model with its numbers as a record has fitted them.
struct FittedModel {
  std::string name;
  FreeModel model;
  std::vector<double> values;
};

/// Noise of a record, by channel: [first block of each channel].
struct RecordNoise {
  double step_s = 0;
  std::vector<std::string> channels;
  std::vector<double> deviation;            ///< of a sample, with what uncertain motion makes of it
  std::vector<std::vector<double>> powers;  ///< N_b >= 1 of each octave, the fastest first
  SearchRule rule = {};                     ///< by which the record was judged
};
/// As the model of `fit` leaves it.
RecordNoise NoiseOf(const FitProblem& problem, const FitResult& fit, double step_s);

struct TestEvidence {
  double expected = 0;     ///< E, of 2 ln of the likelihood ratio
  double margin = -1e300;  ///< E with what the numbers cost, less what chance may do
  double deviation = 1;    ///< root of V
  double probability() const;
};

/// What the true model answers on a motion, and what `rival` makes of it.
/// `driven`: the model on the motion (ForwardModel::Driven); `force_N`: the most that the rig bears,
/// beyond it, as below vacuum, the motion says nothing; `steps`: of the refit.
TestEvidence Expect(std::shared_ptr<const ForwardModel> driven, double step_s,
                    const RecordNoise& noise, double force_N, const FittedModel& truth,
                    const FittedModel& rival, int steps);

}  // namespace phs::identify::search
