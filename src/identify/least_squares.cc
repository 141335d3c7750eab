#include "identify/least_squares.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace phs::identify {
namespace {

/// Huber weights from the residual itself, so that one block of residuals may have outliers.
void Downweight(double width, Eigen::VectorXd* r, Eigen::MatrixXd* j) {
  if (width <= 0) return;
  for (Eigen::Index i = 0; i < r->size(); ++i) {
    const double size = std::abs((*r)[i]);
    if (size <= width) continue;
    // rho = 2 w |r| - w²; the residual of that size and its derivative.
    const double now = std::sqrt(2 * width * size - width * width);
    if (j != nullptr) j->row(i) *= width / now;
    (*r)[i] = std::copysign(now, (*r)[i]);
  }
}

class Cost final : public ceres::CostFunction {
 public:
  explicit Cost(const LeastSquaresProblem& problem) : problem_(problem) {
    set_num_residuals(problem.num_residuals);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.low.size()));
  }
  bool Evaluate(double const* const* x, double* residuals, double** jacobians) const override {
    std::vector<double> at(x[0], x[0] + problem_.low.size());
    for (size_t i = 0; i < at.size(); ++i)
      at[i] = std::clamp(at[i], problem_.low[i], problem_.high[i]);
    const bool derive = jacobians != nullptr && jacobians[0] != nullptr;
    Eigen::VectorXd r;
    Eigen::MatrixXd j;
    if (!problem_.evaluate(at, &r, derive ? &j : nullptr)) return false;
    Downweight(problem_.loss_width, &r, derive ? &j : nullptr);
    std::copy(r.data(), r.data() + r.size(), residuals);
    if (derive) {
      using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
      Eigen::Map<RowMajor>(jacobians[0], j.rows(), j.cols()) = j;
    }
    return true;
  }

 private:
  const LeastSquaresProblem& problem_;
};

}  // namespace

bool SolveLeastSquares(const LeastSquaresProblem& problem, std::vector<double>* x) {
  if (x->empty()) return true;
  FLAGS_minloglevel = google::GLOG_FATAL;  // a refused point is no news for the user
  ceres::Problem solver;
  // Bounds by projection: Ceres' own bounds cost a line search with derivatives per step.
  const int n = static_cast<int>(x->size());
  solver.AddParameterBlock(x->data(), n);
  solver.AddResidualBlock(new Cost(problem), nullptr, x->data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = problem.max_steps;
  options.function_tolerance = problem.tolerance;
  options.initial_trust_region_radius = 100;
  options.max_num_consecutive_invalid_steps = 8;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &solver, &summary);
  for (int i = 0; i < n; ++i) (*x)[i] = std::clamp((*x)[i], problem.low[i], problem.high[i]);
  return summary.IsSolutionUsable();
}

}  // namespace phs::identify
