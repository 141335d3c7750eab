#include "identify/fit/near_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "identify/fit/fit_intervals.h"

namespace phs::identify::search {
namespace {

/// Powers of whole blocks in the place of those of bands.
BandPowers Flattened(const Likelihood& likelihood, BandPowers powers) {
  for (size_t b = 0; b < powers.rows().size(); ++b) {
    double sum = 0;
    std::vector<double>& row = powers.rows()[b];
    for (int k = 0; k < static_cast<int>(row.size()); ++k) {
      sum +=
          row[static_cast<size_t>(k)] * (likelihood.bands(b).end(k) - likelihood.bands(b).begin(k));
    }
    std::fill(row.begin(), row.end(), sum / likelihood.bands(b).size());
  }
  return powers;
}

/// The least-squares problem with the powers held.
class Fitter {
 public:
  Fitter(const FitProblem& problem, const FreeModel& model, const NearFitOptions& options)
      : problem_(problem), model_(model), options_(options), first_(options.first_own) {}

  FitResult Run(const std::vector<double>& start, const Eigen::MatrixXd& kept) {
    at_.values = start;
    if (!Begin(kept)) return at_;
    for (int steps = 0; steps < options_.max_steps; ++steps) {
      if (steps > 0 && first_ < count() && !TakeColumns()) return at_;
      const double before = score_;
      if (!Step()) break;
      SetPowers();
      if (before - score_ < options_.enough && first_ == options_.first_own) break;
    }
    at_.ok = true;
    if (options_.final_slopes && !current_) {
      first_ = 0;
      at_.ok = TakeColumns();
    }
    if (at_.ok && options_.intervals) SetIntervals(problem_, &at_);
    return std::move(at_);
  }

 private:
  int count() const { return static_cast<int>(model_.free.size()); }

  bool Begin(const Eigen::MatrixXd& kept) {
    at_.slopes.resize(problem_.likelihood().size(), count());
    if (first_ > 0) at_.slopes.leftCols(first_) = kept.leftCols(first_);
    at_.residual = problem_.Residual(model_, at_.values);
    ++at_.runs;
    if (at_.residual.size() == 0) return false;
    coefficients_ = problem_.likelihood().Transform(at_.residual);
    if (first_ < count() && !TakeColumns()) return false;
    SetPowers();
    return true;
  }

  /// The columns from `first_` on, about the residual as it is.
  bool TakeColumns() {
    Eigen::MatrixXd own;
    if (!problem_.CalcSlopes(model_, at_.values, first_, at_.residual, &own)) return false;
    at_.runs += count() - first_;
    at_.slopes.rightCols(count() - first_) = problem_.likelihood().Transform(own);
    fresh_ = current_ = first_ == 0;
    first_ = options_.first_own;
    return true;
  }

  /// Of a robust fit the weights stay those of its start: what is rare must not widen them.
  void SetPowers() {
    const Likelihood& likelihood = problem_.likelihood();
    at_.powers = likelihood.Powers(coefficients_);
    at_.score = likelihood.MinusTwoLog(at_.powers);
    if (options_.robust > 0) {
      if (weight_.size() == 0) weight_ = likelihood.Weights(at_.powers);
      score_ = Cost(coefficients_);
      return;
    }
    const BandPowers used = options_.flat ? Flattened(likelihood, at_.powers) : at_.powers;
    weight_ = likelihood.Weights(used);
    score_ = likelihood.MinusTwoLog(used);
  }

  double Cost(const Eigen::VectorXd& coefficients) const {
    const Eigen::VectorXd r = weight_.cwiseProduct(coefficients);
    if (options_.robust <= 0) return r.squaredNorm();
    return options_.robust * options_.robust * (r / options_.robust).array().square().log1p().sum();
  }

  /// One accepted step, or false where none lowers the cost.
  bool Step() {
    const double cost = Cost(coefficients_);
    Eigen::VectorXd weight = weight_;
    if (options_.robust > 0) {
      const Eigen::VectorXd r = weight_.cwiseProduct(coefficients_) / options_.robust;
      weight = weight.cwiseProduct((1 + r.array().square()).rsqrt().matrix());
    }
    const Eigen::VectorXd residual = weight.cwiseProduct(coefficients_);
    const Eigen::MatrixXd slopes = weight.asDiagonal() * at_.slopes;
    double fall = 0, predicted = 0;
    for (int attempt = 0; attempt < 4; ++attempt, lambda_ *= 30) {
      const Eigen::VectorXd step =
          BoundedStep(model_, at_.values, residual, slopes, lambda_, kReach);
      predicted = residual.squaredNorm() - (residual + slopes * step).squaredNorm();
      if (predicted < options_.enough) break;
      std::vector<double> moved = Moved(model_, at_.values, step);
      Eigen::VectorXd r = problem_.Residual(model_, moved);
      ++at_.runs;
      if (r.size() == 0) continue;
      const Eigen::VectorXd coefficients = problem_.likelihood().Transform(r);
      const double next = Cost(coefficients);
      if (!(next < cost)) continue;
      fall = cost - next;
      at_.values = std::move(moved), at_.residual = std::move(r);
      coefficients_ = coefficients, current_ = false;
      lambda_ = std::max(1e-7, lambda_ / 10);
      break;
    }
    const bool aged =
        fall < 0.3 * predicted && predicted > options_.enough && (fall > 0 || !fresh_);
    if (aged) {
      first_ = 0;  // the kept columns have aged
      lambda_ = std::min(lambda_, 1e-3);
    }
    fresh_ = false;
    return fall > 0 || aged;
  }

  static constexpr double kReach = 1.2;  // [ln] of a logarithmic number in one step
  const FitProblem& problem_;
  const FreeModel& model_;
  const NearFitOptions options_;
  FitResult at_;
  Eigen::VectorXd coefficients_, weight_;
  double score_ = 0, lambda_ = 1e-4;
  int first_;
  bool fresh_ = false;
  bool current_ = false;  // all slopes are those about the values
};

}  // namespace

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

Eigen::VectorXd BoundedStep(const FreeModel& model, const std::vector<double>& values,
                            const Eigen::VectorXd& residual, const Eigen::MatrixXd& slopes,
                            double lambda, double reach) {
  const auto count = slopes.cols();
  Eigen::MatrixXd normal = slopes.transpose() * slopes;
  const Eigen::VectorXd gradient = slopes.transpose() * residual;
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
  return Fitter(problem, model, options).Run(start, kept);
}

FitResult FitBothWays(const FitProblem& problem, const FreeModel& model, const FitResult& start,
                      int first_own) {
  NearFitOptions way{.first_own = first_own, .max_steps = 10, .intervals = false};
  FitResult sure = FitNear(problem, model, start.values, start.slopes, way);
  way.flat = true;
  const FitResult large = FitNear(problem, model, start.values, start.slopes, way);
  if (!large.ok) return sure;
  way.flat = false;
  FitResult both = FitNear(problem, model, large.values, large.slopes, way);
  return both.ok && (!sure.ok || both.score < sure.score) ? both : sure;
}

}  // namespace phs::identify::search
