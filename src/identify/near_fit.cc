#include "identify/near_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "identify/fit_intervals.h"

namespace phs::identify::search {
namespace {

std::vector<double> Moved(const FreeModel& model, const std::vector<double>& values,
                          const Eigen::VectorXd& step) {
  std::vector<double> out = values;
  for (size_t i = 0; i < out.size(); ++i) {
    const FreeParameter& p = model.free[i];
    const auto k = static_cast<Eigen::Index>(i);
    if (step[k] != 0) out[i] = p.FromCoordinate(p.ToCoordinate(values[i]) + step[k]);
  }
  return out;
}

/// What a fit minimises: squares of residuals times a weight per channel, or Cauchy's loss.
class Loss {
 public:
  Loss(const FitProblem& problem, const NearFitOptions& options)
      : channels_(problem.num_channels()), robust_(options.robust), balanced_(options.balanced) {}

  /// Takes the channels' weights from the first residual.
  void Start(const Eigen::VectorXd& r) {
    channel_ = Eigen::VectorXd::Ones(r.size());
    if (!balanced_) return;
    const auto n = r.size() / channels_;
    for (int c = 0; c < channels_; ++c) {
      const double ms = r.segment(c * n, n).squaredNorm() / static_cast<double>(n);
      channel_.segment(c * n, n).setConstant(1 / std::sqrt(std::max(1.0, ms)));
    }
  }
  double Cost(const Eigen::VectorXd& r) const {
    if (robust_ <= 0) return r.cwiseProduct(channel_).squaredNorm();
    return robust_ * robust_ * (r / robust_).array().square().log1p().sum();
  }
  /// Roots of the weights that make a least-squares step one of this loss.
  Eigen::VectorXd Weights(const Eigen::VectorXd& r) const {
    if (robust_ <= 0) return channel_;
    return (1 + (r / robust_).array().square()).rsqrt();
  }
  bool IsPlain() const { return robust_ <= 0 && !balanced_; }

 private:
  int channels_;
  double robust_;
  bool balanced_;
  Eigen::VectorXd channel_;
};

}  // namespace

Eigen::VectorXd BoundedStep(const FreeModel& model, const std::vector<double>& values,
                            const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian,
                            double lambda, double reach) {
  const auto count = jacobian.cols();
  Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
  const Eigen::VectorXd gradient = jacobian.transpose() * residual;
  const Eigen::VectorXd damping = lambda * normal.diagonal();
  normal.diagonal() += damping;
  normal.diagonal().array() += 1e-12 * normal.trace() + 1e-300;
  Eigen::VectorXd step = Eigen::VectorXd::Zero(count);
  std::vector<char> held(static_cast<size_t>(count), 0);
  for (int pass = 0; pass < 4; ++pass) {
    // Held coordinates: their row becomes step_i = given.
    Eigen::MatrixXd a = normal;
    Eigen::VectorXd b = -gradient;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (!held[static_cast<size_t>(i)]) continue;
      b -= normal.col(i) * step[i];
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      if (!held[static_cast<size_t>(i)]) continue;
      a.row(i).setZero(), a.col(i).setZero();
      a(i, i) = 1, b[i] = step[i];
    }
    step = a.ldlt().solve(b);
    bool more = false;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (held[static_cast<size_t>(i)]) continue;
      const FreeParameter& p = model.free[static_cast<size_t>(i)];
      const double x = p.ToCoordinate(values[static_cast<size_t>(i)]);
      const double limit = p.logarithmic ? reach : 1e300;
      const double inside = std::clamp(step[i], std::max(-limit, p.ToCoordinate(p.low) - x),
                                       std::min(limit, p.ToCoordinate(p.high) - x));
      if (inside == step[i] || !std::isfinite(step[i])) continue;
      step[i] = inside, held[static_cast<size_t>(i)] = 1, more = true;
    }
    if (!more) break;
  }
  return step.allFinite() ? step : Eigen::VectorXd::Zero(count);
}

FitResult FitNear(const FitProblem& problem, const FreeModel& model,
                  const std::vector<double>& start, const Eigen::MatrixXd& kept,
                  const NearFitOptions& options) {
  FitResult at;
  at.values = start;
  const int count = static_cast<int>(model.free.size());
  Loss loss(problem, options);
  double lambda = 1e-4;
  int first = options.first_own;
  for (int steps = 0; steps < options.max_steps; ++steps) {
    Eigen::MatrixXd own;
    if (first < count) {
      if (!problem.Linearise(model, at.values, first, &at.residual, &own)) return at;
      at.runs += 1 + count - first;
    } else if (steps == 0) {
      at.residual = problem.Residual(model, at.values);
      ++at.runs;
      if (at.residual.size() == 0) return at;
    }
    if (steps == 0) {
      loss.Start(at.residual);
      at.jacobian.resize(at.residual.size(), count);
      if (first > 0) at.jacobian.leftCols(first) = kept.leftCols(first);
    }
    if (first < count) at.jacobian.rightCols(count - first) = own;
    const bool fresh = first == 0;  // every column is of this point
    first = options.first_own;
    const double cost = loss.Cost(at.residual);
    const Eigen::VectorXd weight = loss.Weights(at.residual);
    const Eigen::VectorXd weighted = weight.cwiseProduct(at.residual);
    const Eigen::MatrixXd slopes =
        loss.IsPlain() ? at.jacobian : Eigen::MatrixXd(weight.asDiagonal() * at.jacobian);
    double fall = 0, predicted = 0;
    for (int attempt = 0; attempt < 4; ++attempt, lambda *= 30) {
      const Eigen::VectorXd step = BoundedStep(model, at.values, weighted, slopes, lambda, 1.2);
      const std::vector<double> moved = Moved(model, at.values, step);
      const Eigen::VectorXd r = problem.Residual(model, moved);
      ++at.runs;
      predicted = weighted.squaredNorm() - (weighted + slopes * step).squaredNorm();
      const double next = r.size() > 0 ? loss.Cost(r) : 1e300;
      if (!(next < cost)) {
        if (predicted < options.tolerance * cost) break;
        continue;
      }
      fall = cost - next;
      at.values = moved, at.residual = r;
      lambda = std::max(1e-7, lambda / 10);
      break;
    }
    if (fall < 0.3 * predicted && predicted > options.tolerance * cost && (fall > 0 || !fresh)) {
      first = 0;  // the kept columns have aged
      lambda = std::min(lambda, 1e-3);
    } else if (fall < options.tolerance * cost) {
      break;
    }
    lambda = std::min(lambda, 10.0);
  }
  at.ok = true;
  if (options.final_jacobian) {
    at.ok = problem.Linearise(model, at.values, 0, &at.residual, &at.jacobian);
    at.runs += count + 1;
  }
  if (at.ok) SetIntervals(problem, &at);
  return at;
}

FitResult FitBalanced(const FitProblem& problem, const FreeModel& model,
                      const std::vector<double>& start, const Eigen::MatrixXd& kept,
                      const NearFitOptions& options) {
  constexpr int kMostSteps = 4;
  NearFitOptions plain = options;
  plain.final_jacobian = false;
  FitResult fit = FitNear(problem, model, start, kept, plain);
  if (!fit.ok) return fit;
  const int runs = fit.runs;
  fit = FitNear(problem, model, fit.values, fit.jacobian,
                {.first_own = static_cast<int>(model.free.size()),
                 .max_steps = std::min(kMostSteps, options.max_steps),
                 .balanced = true,
                 .final_jacobian = options.final_jacobian});
  fit.runs += runs;
  return fit;
}

}  // namespace phs::identify::search
