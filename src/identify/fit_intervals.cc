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
  const int n = problem.samples(), channels = problem.num_channels();
  const auto count = result->jacobian.cols();
  double mean = 0, independent = 0;
  result->channel_ms.clear(), result->half_95.clear();
  Eigen::VectorXd residual = result->residual;
  Eigen::MatrixXd jacobian = result->jacobian;
  for (int c = 0; c < channels; ++c) {
    result->channel_ms.push_back(residual.segment(c * n, n).squaredNorm() / n);
    const double weight = 1 / std::sqrt(std::max(1.0, result->channel_ms.back()));
    residual.segment(c * n, n) *= weight, jacobian.middleRows(c * n, n) *= weight;
    mean += residual.segment(c * n, n).squaredNorm() / n / channels;
    independent += EffectiveSamples(residual, c * n, n);
  }
  Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  normal.diagonal().array() += 1e-12 * (normal.trace() + 1e-300);
  const Eigen::MatrixXd inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  const double inflate = mean * n * channels / std::max(1.0, independent);
  // The larger of two: noise of one colour, and blocks of the record that disagree.
  constexpr int kBlocks = 40;
  std::vector<int> block(static_cast<size_t>(n) * static_cast<size_t>(channels));
  for (size_t i = 0; i < block.size(); ++i) {
    block[i] = static_cast<int>(static_cast<long>(i % static_cast<size_t>(n)) * kBlocks / n);
  }
  double quantile = 0;
  const Eigen::VectorXd clustered =
      ClusteredDeviation(jacobian, residual, block, kBlocks, &quantile);
  for (int i = 0; i < count; ++i) {
    const double even = 1.96 * std::sqrt(std::max(0.0, inverse(i, i) * inflate));
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

double IndependentSamples(const Eigen::VectorXd& residual, int channels) {
  const int n = static_cast<int>(residual.size()) / channels;
  double sum = 0;
  for (int c = 0; c < channels; ++c) sum += EffectiveSamples(residual, c * n, n);
  return sum;
}

}  // namespace phs::identify::search
