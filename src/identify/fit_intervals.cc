#include "identify/fit_intervals.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace phs::identify::search {

Eigen::VectorXd ClusteredDeviation(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                                   const std::vector<int>& block_of_row, int blocks,
                                   double* quantile) {
  const auto count = jacobian.cols();
  const double freedom = static_cast<double>(blocks - count);
  if (freedom < 3) return {};
  // Columns of one length, so that the small numbers of one do not drown in the others'.
  const Eigen::VectorXd scale = jacobian.colwise().norm().transpose().cwiseMax(1e-300);
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(blocks, count);
  for (Eigen::Index i = 0; i < residual.size(); ++i) {
    scores.row(block_of_row[static_cast<size_t>(i)]) += residual[i] * jacobian.row(i);
  }
  scores *= scale.cwiseInverse().asDiagonal();
  Eigen::MatrixXd normal = scale.cwiseInverse().asDiagonal() * (jacobian.transpose() * jacobian) *
                           scale.cwiseInverse().asDiagonal();
  normal.diagonal().array() += 1e-12;
  const Eigen::MatrixXd half = normal.ldlt().solve(scores.transpose());
  // Student's 97.5 % quantile: Cornish and Fisher's first term in 1/freedom.
  *quantile = 1.96 + (std::pow(1.96, 3) + 1.96) / (4 * freedom);
  const double finite = std::sqrt(blocks / freedom);
  return finite * half.rowwise().norm().cwiseQuotient(scale);
}

void SetIntervals(const FitProblem& problem, FitResult* result) {
  constexpr int kBlocks = 40;
  const Likelihood& likelihood = problem.likelihood();
  result->channel_ms.clear(), result->half_95.clear();
  for (const Block& block : likelihood.blocks()) {
    const double square = result->residual.segment(block.begin, block.count).squaredNorm();
    result->channel_ms.push_back(square / (block.count * std::max(block.present, 1e-3)));
  }
  const Eigen::VectorXd weight = likelihood.Weights(result->powers);
  const Eigen::VectorXd r = weight.cwiseProduct(likelihood.Transform(result->residual));
  const Eigen::MatrixXd slopes = weight.asDiagonal() * result->slopes;
  // Variance of a weighted coefficient: its weight times its deviation, squared.
  const Eigen::VectorXd spread = weight.cwiseProduct(likelihood.Deviations(result->powers));
  const auto count = slopes.cols();
  Eigen::MatrixXd normal = slopes.transpose() * slopes;
  normal.diagonal().array() += 1e-12 * (normal.trace() + 1e-300);
  const Eigen::MatrixXd inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  const Eigen::MatrixXd scattered = spread.asDiagonal() * slopes;
  const Eigen::MatrixXd variance = inverse * (scattered.transpose() * scattered) * inverse;
  double quantile = 0;
  const Eigen::VectorXd clustered =
      ClusteredDeviation(slopes, r, likelihood.Parts(kBlocks), kBlocks, &quantile);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double even = 1.96 * std::sqrt(std::max(0.0, variance(i, i)));
    result->half_95.push_back(clustered.size() > 0 ? std::max(even, quantile * clustered[i])
                                                   : even);
  }
}

double EffectiveSamples(const Eigen::VectorXd& residual, int begin, int count) {
  const Eigen::VectorXd r = residual.segment(begin, count);
  const double power = r.squaredNorm();
  if (!(power > 0)) return 1;
  double sum = 1;
  for (int lag = 1, stride = 1; lag < count / 4; lag += stride) {
    const double rho = r.head(count - lag).dot(r.tail(count - lag)) / power;
    if (rho < 0.05) break;
    sum += 2 * rho * stride;
    stride = lag < 20 ? 1 : lag / 10;
  }
  return std::max(4.0, count / sum);
}

double IndependentSamples(const Eigen::VectorXd& residual, const std::vector<Block>& blocks) {
  double sum = 0;
  for (const Block& block : blocks) sum += EffectiveSamples(residual, block.begin, block.count);
  return sum;
}

}  // namespace phs::identify::search
