#include "identify/fit/fit_intervals.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace phs::identify::search {
namespace {

/// Student's 97.5 % quantile: Cornish and Fisher's first two terms in 1/freedom.
double StudentQuantile(double freedom) {
  constexpr double z = 1.96;
  return z + (z * z * z + z) / (4 * freedom) +
         (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * freedom * freedom);
}

}  // namespace

std::vector<double> EvenHalfWidths(const Likelihood& likelihood, const BandPowers& powers,
                                   const Eigen::MatrixXd& slopes) {
  const Eigen::VectorXd weight = likelihood.Weights(powers);
  const Eigen::VectorXd deviation = likelihood.Deviations(powers);
  const auto count = slopes.cols();
  Eigen::MatrixXd normal = slopes.transpose() * slopes;
  normal.diagonal().array() += 1e-12 * (normal.trace() + 1e-300);
  // Rows: by how much each number follows each weighted coefficient.
  const Eigen::MatrixXd follows = normal.ldlt().solve(slopes.transpose());
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(count), doubt = variance;
  Eigen::Index first = 0;
  for (size_t b = 0; b < likelihood.blocks().size(); ++b) {
    const OctaveBands& bands = likelihood.bands(b);
    for (int k = 0; k < bands.num_bands(); ++k) {
      const Eigen::Index begin = first + bands.begin(k), n = bands.end(k) - bands.begin(k);
      const double taken =
          (follows.middleCols(begin, n).transpose().cwiseProduct(slopes.middleRows(begin, n)))
              .sum();
      // Mean and slope were taken off what the other coefficients of the last band are made of.
      const int twice = k + 1 == bands.num_bands() ? 2 : 0;
      const double there = likelihood.blocks()[b].present * static_cast<double>(n);
      const double freedom = std::max(1.0, there - twice - taken);
      const double floor = std::pow(deviation[begin], 2);  // the power itself where it is above
      double power = std::max(floor, powers(b, k) * there / freedom);
      power *= 1 + there * likelihood.Shared(b, k);  // what theory leaves open they tell as one
      const Eigen::VectorXd part =
          std::pow(weight[begin], 2) * power * follows.middleCols(begin, n).rowwise().squaredNorm();
      variance += part;
      doubt += part.cwiseProduct(part) / freedom;
    }
    first += bands.size();
  }
  variance += follows.rightCols(follows.cols() - first).rowwise().squaredNorm();  // of theories
  std::vector<double> half;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double freedom = doubt[i] > 0 ? variance[i] * variance[i] / doubt[i] : 1e9;
    half.push_back(StudentQuantile(std::max(3.0, freedom)) * std::sqrt(variance[i]));
  }
  return half;
}

std::vector<double> JackknifeHalfWidths(const Eigen::MatrixXd& jacobian,
                                        const Eigen::VectorXd& residual,
                                        const std::vector<int>& block_of_row, int blocks) {
  const auto count = jacobian.cols();
  if (blocks - count < 3) return {};
  // Columns of one length, so that the small numbers of one do not drown in the others'.
  const Eigen::VectorXd scale = jacobian.colwise().norm().transpose().cwiseMax(1e-300);
  const Eigen::MatrixXd columns = jacobian * scale.cwiseInverse().asDiagonal();
  std::vector<Eigen::MatrixXd> normals(static_cast<size_t>(blocks),
                                       Eigen::MatrixXd::Zero(count, count));
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(count, blocks);
  for (Eigen::Index i = 0; i < residual.size(); ++i) {
    const int b = block_of_row[static_cast<size_t>(i)];
    scores.col(b) += residual[i] * columns.row(i).transpose();
    normals[static_cast<size_t>(b)] += columns.row(i).transpose() * columns.row(i);
  }
  Eigen::MatrixXd normal = columns.transpose() * columns;
  normal.diagonal().array() += 1e-12;
  const Eigen::MatrixXd inverse = normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd shares = variance, squares = variance;
  for (int b = 0; b < blocks; ++b) {
    const Eigen::MatrixXd& own = normals[static_cast<size_t>(b)];
    variance += (normal - own).ldlt().solve(scores.col(b)).cwiseAbs2();
    const Eigen::VectorXd share = (inverse * own * inverse).diagonal();
    shares += share, squares += share.cwiseAbs2();
  }
  std::vector<double> half(static_cast<size_t>(count), 0.0);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double freedom = shares[i] * shares[i] / squares[i] - 1;
    if (!(freedom >= 3)) continue;
    half[static_cast<size_t>(i)] =
        StudentQuantile(freedom) * std::sqrt(variance[i] * (blocks - 1) / blocks) / scale[i];
  }
  return half;
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
  result->half_95 = EvenHalfWidths(likelihood, result->powers, slopes);
  const std::vector<double> apart =
      JackknifeHalfWidths(slopes, r, likelihood.Parts(kBlocks), kBlocks);
  for (size_t i = 0; i < apart.size(); ++i) {
    result->half_95[i] = std::max(result->half_95[i], apart[i]);
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
