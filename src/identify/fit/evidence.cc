#include "identify/fit/evidence.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace phs::identify::search {
namespace {

constexpr int kParts = 6;        // of the window, left out in turn
constexpr double kLinear = 0.1;  // coordinates: a refit goes no further than its line holds

/// -2 ln L of the coefficients that parts of the record have about a fit to the others.
double HeldOut(const FitProblem& problem, const FitResult& fit) {
  const Likelihood& likelihood = problem.likelihood();
  const Eigen::VectorXd coefficients = likelihood.Transform(fit.residual);
  const Eigen::VectorXd weight = likelihood.Weights(fit.powers);
  const std::vector<int> part = likelihood.Parts(kParts);
  const auto k = fit.slopes.cols();
  std::vector<Eigen::MatrixXd> normal(kParts, Eigen::MatrixXd::Zero(k, k));
  std::vector<Eigen::VectorXd> right(kParts, Eigen::VectorXd::Zero(k));
  std::vector<std::vector<Eigen::Index>> rows(kParts);
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    rows[static_cast<size_t>(part[static_cast<size_t>(i)])].push_back(i);
  }
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(k, k);
  Eigen::VectorXd all_right = Eigen::VectorXd::Zero(k);
  for (size_t b = 0; b < kParts; ++b) {
    const Eigen::MatrixXd j = weight(rows[b]).asDiagonal() * fit.slopes(rows[b], Eigen::all);
    const Eigen::VectorXd r = weight(rows[b]).cwiseProduct(coefficients(rows[b]));
    normal[b] = j.transpose() * j, right[b] = j.transpose() * r;
    all += normal[b], all_right += right[b];
  }
  Eigen::VectorXd held = coefficients;
  for (size_t b = 0; b < kParts; ++b) {
    Eigen::MatrixXd rest = all - normal[b];
    rest.diagonal() += 1e-3 * all.diagonal() + Eigen::VectorXd::Constant(k, 1e-12);
    Eigen::VectorXd step = rest.ldlt().solve(right[b] - all_right);
    step *= std::min(1.0, kLinear / std::max(1e-300, step.cwiseAbs().maxCoeff()));
    held(rows[b]) += fit.slopes(rows[b], Eigen::all) * step;
  }
  return likelihood.MinusTwoLog(likelihood.Powers(held));
}

/// Of what `best` shows beyond its noise; what the others show more than before counts against it, as a
/// share of what they or `best` had shown: where another cause rules a channel, a little more in it
/// is little.
double ShareOfBest(const std::vector<double>& without, const std::vector<double>& with,
                   size_t best) {
  if (!(without[best] > 0)) return 0;
  double share = 1 - with[best] / without[best];
  for (size_t b = 0; b < without.size(); ++b) {
    if (b == best) continue;
    share -= std::max(0.0, with[b] - without[b]) / std::max(without[b], without[best]);
  }
  return share;
}

}  // namespace

Evidence Compare(const FitProblem& problem, const FitResult& without, const FitResult& with,
                 double tried) {
  const Likelihood& likelihood = problem.likelihood();
  const double count = likelihood.Count();
  Evidence e;
  e.delta_bic = Criterion(problem, without.score, without.values.size()) -
                Criterion(problem, with.score, with.values.size()) -
                (problem.rule().structures ? 2 * std::log(std::max(1.0, tried)) : 0);
  const std::vector<double> excess = likelihood.Excess(without.powers),
                            left = likelihood.Excess(with.powers);
  double mean = 0, most = -1e300;
  size_t best = 0;
  for (size_t b = 0; b < excess.size(); ++b) {
    const double change = std::log(with.channel_ms[b] / std::max(1e-300, without.channel_ms[b]));
    mean += change / static_cast<double>(excess.size());
    const int block = static_cast<int>(b);
    const double gain =
        likelihood.MinusTwoLog(without.powers, block) - likelihood.MinusTwoLog(with.powers, block);
    if (gain <= most) continue;
    most = gain, best = b;
    e.best_channel = problem.block_name(b);
    e.best_channel_gain = 1 - std::exp(0.5 * change);
  }
  e.share = ShareOfBest(excess, left, best);
  e.estimation_gain = 1 - std::exp(0.5 * mean);
  e.cross_validation_gain =
      1 - std::exp(-0.5 * (HeldOut(problem, without) - HeldOut(problem, with)) / count);
  return e;
}

double Criterion(const FitProblem& problem, double score, size_t numbers) {
  return score + static_cast<double>(numbers) * std::log(problem.likelihood().Count());
}

}  // namespace phs::identify::search
