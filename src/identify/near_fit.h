// Fits that start near their end: Levenberg–Marquardt with as few runs of the model as it takes.
//
// A run of the rig model costs milliseconds, a column of the Jacobian one run. Between neighbouring
// points most columns hardly change, so they are kept as long as the steps they give come out as
// predicted (a chord method, Dennis and Schnabel 1996, ch. 5); only the columns of the numbers that
// have just come in are taken anew at every step.
#pragma once

#include <vector>

#include "identify/search_fit.h"

namespace phs::identify::search {

/// A Gauss–Newton step of all coordinates, damped by `lambda` (relative to the normal matrix), held
/// inside the bounds and within `reach` for logarithmic numbers; what hits a bound is held there
/// and the others solved again.
Eigen::VectorXd BoundedStep(const FreeModel& model, const std::vector<double>& values,
                            const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian,
                            double lambda, double reach);

struct NearFitOptions {
  int first_own = 0;  ///< columns from here on are taken anew at every step
  int max_steps = 6;
  double tolerance = 1e-4;  ///< stop when the sum of squares falls by less, relative
  /// > 0: Cauchy's loss s² ln(1 + (r/s)²) instead of squares, s in noise levels: what most of the
  /// record says, deaf to a rare strong deviation.
  double robust = 0;
  /// Channels weighed by what each leaves at the start, as if that were its noise (maximum
  /// likelihood with a variance per channel): what one channel lacks does not bend the others.
  bool balanced = false;
  bool final_jacobian = false;  ///< all columns at the end
};

/// `kept`: columns of the numbers before `first_own`, at or near `start`.
FitResult FitNear(const FitProblem& problem, const FreeModel& model,
                  const std::vector<double>& start, const Eigen::MatrixXd& kept,
                  const NearFitOptions& options);

/// The same, then balanced from where that ends.
FitResult FitBalanced(const FitProblem& problem, const FreeModel& model,
                      const std::vector<double>& start, const Eigen::MatrixXd& kept,
                      const NearFitOptions& options);

}  // namespace phs::identify::search
