#include "identify/evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "identify/fit_intervals.h"

namespace phs::identify::search {
namespace {

/// Normal equations of one block of the estimation window.
struct Block {
  int begin = 0, count = 0;
  Eigen::MatrixXd normal;
  Eigen::VectorXd right;
};

constexpr int kBlocks = 6;
constexpr double kLinear = 0.1;  // coordinates: a refit goes no further than its line holds

std::vector<Block> SplitFit(const FitProblem& problem, const FitResult& fit) {
  const int n = problem.samples();
  const auto k = fit.jacobian.cols();
  std::vector<Block> blocks(kBlocks);
  for (int b = 0; b < kBlocks; ++b) {
    Block& block = blocks[b];
    block.begin = b * n / kBlocks;
    block.count = (b + 1) * n / kBlocks - block.begin;
    block.normal = Eigen::MatrixXd::Zero(k, k);
    block.right = Eigen::VectorXd::Zero(k);
    for (int c = 0; c < problem.num_channels(); ++c) {
      const auto j = fit.jacobian.middleRows(c * n + block.begin, block.count);
      const double w = 1 / std::max(1e-300, fit.channel_ms[c]);
      block.normal.noalias() += w * j.transpose() * j;
      block.right.noalias() +=
          w * j.transpose() * fit.residual.segment(c * n + block.begin, block.count);
    }
  }
  return blocks;
}

constexpr double kClear = 0.94;  // of a mean square: 3 % of the residual

/// Share of what a mean square exceeds that of noise and input by.
double ExcessRemoved(double without, double with) {
  constexpr double kSure = 1.04;  // what the estimate of the noise may be off by
  return without > kSure ? std::min(1.0, (without - with) / (without - 1)) : 0;
}

double WeightedLog(const std::vector<double>& square, const std::vector<double>& weight) {
  double sum = 0, total = 0;
  for (size_t c = 0; c < square.size(); ++c) {
    sum += weight[c] * std::log(std::max(1e-300, square[c]));
    total += weight[c];
  }
  return sum / total;
}

/// Mean square of each channel's residual on blocks held out of a linear refit.
std::vector<double> CrossValidated(const FitProblem& problem, const FitResult& fit) {
  const int n = problem.samples(), channels = problem.num_channels();
  const auto k = fit.jacobian.cols();
  const std::vector<Block> blocks = SplitFit(problem, fit);
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(k, k);
  Eigen::VectorXd all_right = Eigen::VectorXd::Zero(k);
  for (const Block& b : blocks) all += b.normal, all_right += b.right;
  std::vector<double> held(channels, 0.0);
  for (const Block& b : blocks) {
    Eigen::MatrixXd rest = all - b.normal;
    rest.diagonal() += 1e-3 * all.diagonal() + Eigen::VectorXd::Constant(k, 1e-12);
    Eigen::VectorXd step = rest.ldlt().solve(b.right - all_right);
    step *= std::min(1.0, kLinear / std::max(1e-300, step.cwiseAbs().maxCoeff()));
    for (int c = 0; c < channels; ++c) {
      held[c] += (fit.residual.segment(c * n + b.begin, b.count) +
                  fit.jacobian.middleRows(c * n + b.begin, b.count) * step)
                     .squaredNorm() /
                 n;
    }
  }
  return held;
}

/// Variance of what the last kOrder samples of y do not foretell: prediction
/// error of an autoregression (Levinson 1946, J. Math. Phys. 25, 261).
double InnovationVariance(const Eigen::VectorXd& y) {
  constexpr int kOrder = 8;
  const auto n = y.size();
  double rho[kOrder + 1];
  for (int lag = 0; lag <= kOrder; ++lag) {
    rho[lag] = y.head(n - lag).dot(y.tail(n - lag)) / static_cast<double>(n);
  }
  double error = std::max(rho[0], 1e-300), a[kOrder + 1] = {};
  for (int m = 1; m <= kOrder; ++m) {
    double k = rho[m];
    for (int j = 1; j < m; ++j) k -= a[j] * rho[m - j];
    k /= error;
    double next[kOrder + 1];
    for (int j = 1; j < m; ++j) next[j] = a[j] - k * a[m - j];
    std::copy(next + 1, next + m, a + 1);
    a[m] = k;
    error = std::max(error * (1 - k * k), 1e-12 * rho[0] + 1e-300);
  }
  return error;
}

/// Fall of the information criterion of the whitened residuals.
double WhitenedBic(const FitProblem& problem, const FitResult& without, const FitResult& with) {
  const int n = problem.samples();
  double fall = 0;
  for (int c = 0; c < problem.num_channels(); ++c) {
    fall += n * std::log(InnovationVariance(without.residual.segment(c * n, n)) /
                         InnovationVariance(with.residual.segment(c * n, n)));
  }
  const double extra = double(with.values.size()) - double(without.values.size());
  return fall - extra * std::log(double(n) * problem.num_channels());
}

}  // namespace

Evidence Compare(const FitProblem& problem, const FitResult& without, const FitResult& with) {
  std::vector<double> independent;
  const int n = problem.samples();
  for (int c = 0; c < problem.num_channels(); ++c) {
    independent.push_back(EffectiveSamples(with.residual, c * n, n));
  }
  const double total = std::accumulate(independent.begin(), independent.end(), 0.0);
  const double extra = double(with.values.size()) - double(without.values.size());
  Evidence e;
  e.correlated_bic = total * (WeightedLog(without.channel_ms, independent) -
                              WeightedLog(with.channel_ms, independent)) -
                     extra * std::log(total);
  e.whitened_bic = WhitenedBic(problem, without, with);
  e.delta_bic = std::max(e.correlated_bic, e.whitened_bic);
  double mean = 0, excess = 0, left = 0;
  for (size_t c = 0; c < with.channel_ms.size(); ++c) {
    const double change = std::log(with.channel_ms[c] / without.channel_ms[c]);
    mean += change / static_cast<double>(with.channel_ms.size());
    excess += std::max(0.0, without.channel_ms[c] - 1);
    left += std::max(0.0, with.channel_ms[c] - 1);
    const double gain = 1 - std::exp(0.5 * change);
    if (c == 0 || gain > e.best_channel_gain) {
      e.best_channel_gain = gain, e.best_channel = problem.data().outputs[c].name;
      e.best_channel_left = with.channel_ms[c];
    }
  }
  e.estimation_gain = 1 - std::exp(0.5 * mean);
  e.excess_removed = excess > 0 ? 1 - left / excess : 0;
  const std::vector<double> held = CrossValidated(problem, with);
  const std::vector<double> held_without = CrossValidated(problem, without);
  const std::vector<double> alike(held.size(), 1.0);
  e.cross_validation_gain =
      1 - std::exp(0.5 * (WeightedLog(held, alike) - WeightedLog(held_without, alike)));
  for (size_t c = 0; c < held.size(); ++c) {
    const bool pressure = problem.data().outputs[c].name.ends_with("_Pa");
    if (!pressure || problem.data().kind == rigs::RigKind::kFull) continue;
    if (with.channel_ms[c] > kClear * without.channel_ms[c]) continue;
    const double removed = std::min(ExcessRemoved(without.channel_ms[c], with.channel_ms[c]),
                                    ExcessRemoved(held_without[c], held[c]));
    e.pressure_removed = std::max(e.pressure_removed, removed);
  }
  return e;
}

double MeanLogSquare(const Eigen::VectorXd& residual, int channels) {
  const auto n = residual.size() / channels;
  double sum = 0;
  for (int c = 0; c < channels; ++c) {
    sum += std::log(
        std::max(1e-300, residual.segment(c * n, n).squaredNorm() / static_cast<double>(n)));
  }
  return sum / channels;
}

}  // namespace phs::identify::search
