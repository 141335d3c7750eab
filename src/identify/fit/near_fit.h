// Fits by Levenberg–Marquardt with as few runs of the model as it takes.
//
// Minimised is -2 ln L of likelihood.h over the numbers and the powers of the discrepancy in turn:
// with the powers held it is a least-squares problem of the coefficients over their deviation, with
// the numbers held the powers are those of the residual (iteratively reweighted least squares;
// either half lowers -2 ln L).
//
// A run of the rig model costs milliseconds, a column of the Jacobian one run. Between neighbouring
// points most columns hardly change, so they are kept as long as the steps they give come out as
// predicted (a chord method, Dennis and Schnabel 1996, ch. 5); only the columns of the numbers that
// have just come in are taken anew at every step.
#pragma once

#include <vector>

#include "identify/fit/search_fit.h"

namespace phs::identify::search {

/// A Gauss–Newton step of all coordinates, damped by `lambda` (relative to the normal matrix), held
/// inside the bounds and within `reach` for logarithmic numbers; what hits a bound is held there
/// and the others solved again. `residual` and `slopes`: coefficients over their deviation.
Eigen::VectorXd BoundedStep(const FreeModel& model, const std::vector<double>& values,
                            const Eigen::VectorXd& residual, const Eigen::MatrixXd& slopes,
                            double lambda, double reach);

/// The values after a step of their coordinates.
std::vector<double> Moved(const FreeModel& model, const std::vector<double>& values,
                          const Eigen::VectorXd& step);

struct NearFitOptions {
  int first_own = 0;  ///< columns from here on are taken anew at every step
  int max_steps = 6;
  /// > 0: Cauchy's loss s² ln(1 + (r/s)²) of each coefficient, s in deviations: what most of the
  /// record says, deaf to a rare strong deviation.
  double robust = 0;
  /// Powers by block alone, the same for every band: the fit that an engineer expects of a model
  /// that lacks something. It follows what is large; the likelihood, what is sure.
  bool flat = false;
  bool final_slopes = false;  ///< all columns at the end
  double enough = 0.5;        ///< less to be had ends the fit [-2 ln L]: a comparison asks for more
  bool intervals = true;      ///< half_95 and channel_ms of the result; else they stay empty
};

/// `kept`: columns of the numbers before `first_own`, as coefficients, at or near `start`.
FitResult FitNear(const FitProblem& problem, const FreeModel& model,
                  const std::vector<double>& start, const Eigen::MatrixXd& kept,
                  const NearFitOptions& options);

/// From `start` by likelihood, and by plain least squares followed by likelihood: the better of the
/// two, without intervals. Where much is left, what is large shows the way; where little is, what is
/// sure.
FitResult FitBothWays(const FitProblem& problem, const FreeModel& model, const FitResult& start,
                      int first_own);

}  // namespace phs::identify::search
