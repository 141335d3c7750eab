// Bounded nonlinear least squares by Levenberg–Marquardt (Ceres) for a residual given as a
// function that also delivers its derivative.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace phs::identify {

/// Fills `residual` and, where not null, `jacobian` (rows: residual, columns: coordinates) at x.
/// False: the point is not allowed.
using ResidualFunction = std::function<bool(const std::vector<double>& x, Eigen::VectorXd* residual,
                                            Eigen::MatrixXd* jacobian)>;

struct LeastSquaresProblem {
  ResidualFunction evaluate;
  int num_residuals = 0;
  std::vector<double> low, high;  ///< bounds of the coordinates
  int max_steps = 20;
  double tolerance = 1e-6;  ///< relative change of the sum of squares that ends the search
  double loss_width = 0;    ///< > 0: Huber loss beyond this residual
};

/// Moves `x` to the best point found. False: no usable point.
bool SolveLeastSquares(const LeastSquaresProblem& problem, std::vector<double>* x);

}  // namespace phs::identify
