#include "analysis/harmonic_balance.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace phs::analysis {
namespace {

/// Of the mean of a state that nothing else brings back, a seal that sticks: it creeps home within
/// this part of a radian.
constexpr double kForgetting = 1e-4;
/// Newton steps below this go on as long as they shrink: down to the noise of the differences.
constexpr double kNearEnough = 1e-3;

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// 1, cos, sin, cos 2, sin 2, … at a phase.
VectorXd Waves(double phase, Eigen::Index columns) {
  VectorXd w(columns);
  w[0] = 1;
  for (Eigen::Index k = 1; 2 * k < columns; ++k) {
    w[2 * k - 1] = std::cos(static_cast<double>(k) * phase);
    w[2 * k] = std::sin(static_cast<double>(k) * phase);
  }
  return w;
}

/// Coefficients of the derivative over the phase: x D.
MatrixXd Derivative(Eigen::Index columns) {
  MatrixXd D = MatrixXd::Zero(columns, columns);
  for (Eigen::Index k = 1; 2 * k < columns; ++k) {
    D(2 * k, 2 * k - 1) = static_cast<double>(k);
    D(2 * k - 1, 2 * k) = -static_cast<double>(k);
  }
  return D;
}

class Balance {
 public:
  Balance(const VibratingSystem& system, const BalanceLine& line, Eigen::Index columns, int samples)
      : system_(system),
        line_(line),
        np_(system.positions),
        n_(system.positions + system.states),
        D_(Derivative(columns)),
        waves_(columns, samples),
        weights_(columns, samples) {
    for (int j = 0; j < samples; ++j) {
      waves_.col(j) = Waves(2 * std::numbers::pi * j / samples, columns);
    }
    weights_ = waves_ * (2.0 / samples);
    weights_.row(0) /= 2;
  }

  /// What the harmonics of the equations lack, column by column; then the line and phase zero.
  VectorXd Residual(const PeriodicMotion& m) const {
    MatrixXd lacking = Inertia(m);
    for (Eigen::Index j = 0; j < waves_.cols(); ++j) {
      lacking -= system_.rates(m.parameter, Point(m, j)) * weights_.col(j).transpose();
    }
    VectorXd r(lacking.size() + 2);
    r.head(lacking.size()) = lacking.reshaped();
    r[lacking.size()] = line_.of_amplitude * system_.watched.dot(m.coefficients.col(1).head(np_)) +
                        line_.of_parameter * m.parameter - line_.value;
    r[lacking.size() + 1] = system_.watched.dot(m.coefficients.col(2).head(np_));
    return r;
  }

  /// Its derivative over the coefficients, omega and the parameter.
  MatrixXd Slope(const PeriodicMotion& m) const {
    const Eigen::Index K = waves_.rows(), size = n_ * K;
    MatrixXd J = MatrixXd::Zero(size + 2, size + 2);
    AddInertiaSlope(m, &J);
    for (Eigen::Index j = 0; j < waves_.cols(); ++j) AddSample(m, j, &J);
    J.block(size, n_, 1, np_) = line_.of_amplitude * system_.watched.transpose();
    J(size, size + 1) = line_.of_parameter;
    J.block(size + 1, 2 * n_, 1, np_) = system_.watched.transpose();
    return J;
  }

 private:
  VectorXd Point(const PeriodicMotion& m, Eigen::Index j) const {
    VectorXd x(2 * np_ + n_ - np_);
    x.head(np_) = m.coefficients.topRows(np_) * waves_.col(j);
    x.segment(np_, np_) = m.omega * (m.coefficients.topRows(np_) * (D_ * waves_.col(j)));
    x.tail(n_ - np_) = m.coefficients.bottomRows(n_ - np_) * waves_.col(j);
    return x;
  }

  /// Harmonics of q'' and z'.
  MatrixXd Inertia(const PeriodicMotion& m) const {
    MatrixXd out(n_, waves_.rows());
    out.topRows(np_) = m.omega * m.omega * (m.coefficients.topRows(np_) * D_ * D_);
    out.bottomRows(n_ - np_) = m.omega * (m.coefficients.bottomRows(n_ - np_) * D_);
    out.col(0).tail(n_ - np_) += kForgetting * m.omega * m.coefficients.col(0).tail(n_ - np_);
    return out;
  }

  void AddInertiaSlope(const PeriodicMotion& m, MatrixXd* J) const {
    const Eigen::Index K = waves_.rows(), ns = n_ - np_;
    const MatrixXd DD = D_ * D_;
    for (Eigen::Index k = 0; k < K; ++k) {
      for (Eigen::Index l = 0; l < K; ++l) {
        J->block(k * n_, l * n_, np_, np_).diagonal().array() += m.omega * m.omega * DD(l, k);
        J->block(k * n_ + np_, l * n_ + np_, ns, ns).diagonal().array() += m.omega * D_(l, k);
      }
    }
    J->block(np_, np_, ns, ns).diagonal().array() += kForgetting * m.omega;
    MatrixXd over_omega(n_, K);
    over_omega.topRows(np_) = 2 * m.omega * (m.coefficients.topRows(np_) * DD);
    over_omega.bottomRows(ns) = m.coefficients.bottomRows(ns) * D_;
    J->col(n_ * K).head(n_ * K) += over_omega.reshaped();
  }

  void AddSample(const PeriodicMotion& m, Eigen::Index j, MatrixXd* J) const {
    const Eigen::Index K = waves_.rows(), ns = n_ - np_;
    const VectorXd x = Point(m, j);
    MatrixXd A(n_, x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      VectorXd plus = x, minus = x;
      plus[i] += system_.steps[i];
      minus[i] -= system_.steps[i];
      A.col(i) = (system_.rates(m.parameter, plus) - system_.rates(m.parameter, minus)) /
                 (2 * system_.steps[i]);
    }
    const double step = system_.parameter_step;
    const VectorXd over_parameter =
        (system_.rates(m.parameter + step, x) - system_.rates(m.parameter - step, x)) / (2 * step);
    const VectorXd turning = D_ * waves_.col(j);
    const VectorXd over_omega = A.middleCols(np_, np_) * (m.coefficients.topRows(np_) * turning);
    MatrixXd column(n_, n_);
    for (Eigen::Index l = 0; l < K; ++l) {
      column.leftCols(np_) =
          A.leftCols(np_) * waves_(l, j) + A.middleCols(np_, np_) * (m.omega * turning[l]);
      column.rightCols(ns) = A.rightCols(ns) * waves_(l, j);
      for (Eigen::Index k = 0; k < K; ++k) {
        J->block(k * n_, l * n_, n_, n_) -= weights_(k, j) * column;
      }
    }
    for (Eigen::Index k = 0; k < K; ++k) {
      J->col(n_ * K).segment(k * n_, n_) -= weights_(k, j) * over_omega;
      J->col(n_ * K + 1).segment(k * n_, n_) -= weights_(k, j) * over_parameter;
    }
  }

  const VibratingSystem& system_;
  BalanceLine line_;
  Eigen::Index np_, n_;
  MatrixXd D_, waves_, weights_;
};

PeriodicMotion Moved(const PeriodicMotion& m, const VectorXd& step, double share) {
  PeriodicMotion out = m;
  out.coefficients.reshaped() += share * step.head(m.coefficients.size());
  out.omega += share * step[m.coefficients.size()];
  out.parameter += share * step[m.coefficients.size() + 1];
  return out;
}

/// Of a step, relative: coefficients over the amplitude, omega, parameter.
double Length(const VectorXd& step, const PeriodicMotion& m, double amplitude) {
  const Eigen::Index size = m.coefficients.size();
  return step.head(size).norm() / amplitude + std::abs(step[size]) / m.omega +
         std::abs(step[size + 1]) / std::abs(m.parameter);
}

}  // namespace

VectorXd PeriodicMotion::At(double phase, int positions) const {
  const VectorXd w = Waves(phase, coefficients.cols());
  const VectorXd turning = Derivative(coefficients.cols()) * w;
  VectorXd x(positions + coefficients.rows());
  x.head(positions) = coefficients.topRows(positions) * w;
  x.segment(positions, positions) = omega * (coefficients.topRows(positions) * turning);
  x.tail(coefficients.rows() - positions) =
      coefficients.bottomRows(coefficients.rows() - positions) * w;
  return x;
}

double PeriodicMotion::Amplitude(const VectorXd& weights, int k) const {
  const auto of = [&](int column) {
    return weights.dot(coefficients.col(column).head(weights.size()));
  };
  return k == 0 ? of(0) : std::hypot(of(2 * k - 1), of(2 * k));
}

PeriodicMotion PeriodicMotion::WithHarmonics(int n) const {
  PeriodicMotion out = *this;
  out.coefficients = MatrixXd::Zero(coefficients.rows(), 2 * n + 1);
  const Eigen::Index kept = std::min(coefficients.cols(), out.coefficients.cols());
  out.coefficients.leftCols(kept) = coefficients.leftCols(kept);
  return out;
}

Result<PeriodicMotion> SolveBalance(const VibratingSystem& system, const PeriodicMotion& near,
                                    double amplitude, const BalanceOptions& options) {
  return SolveBalance(system, near, BalanceLine{.value = amplitude}, options);
}

Result<PeriodicMotion> SolveBalance(const VibratingSystem& system, const PeriodicMotion& near,
                                    const BalanceLine& line, const BalanceOptions& options) {
  const double amplitude = near.Amplitude(system.watched, 1);
  const Error failed{"harmonic balance",
                     "found no motion of amplitude " + std::to_string(amplitude), "",
                     "a smaller step of the amplitude, more samples"};
  const Balance balance(system, line, near.coefficients.cols(), options.samples);
  PeriodicMotion m = near;
  VectorXd residual = balance.Residual(m);
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < options.iterations; ++i) {
    const Eigen::PartialPivLU<MatrixXd> slope(balance.Slope(m));
    const VectorXd step = slope.solve(-residual);
    const double length = Length(step, m, amplitude);
    if (!std::isfinite(length)) return failed;
    const bool near_enough = length < kNearEnough;
    if (length < options.tolerance || (near_enough && length > before / 2)) {
      return Moved(m, step, 1);
    }
    before = length;
    double share = 1;
    for (;; share /= 2) {
      if (share < 1.0 / 64) return failed;
      const PeriodicMotion next = Moved(m, step, share);
      if (!(next.omega > 0)) continue;
      const VectorXd left = balance.Residual(next);
      if (!left.allFinite()) continue;
      const double then = Length(slope.solve(-left), m, amplitude);
      if (!near_enough && then > (1 - share / 4) * length) continue;
      m = next;
      residual = left;
      break;
    }
  }
  return failed;
}

}  // namespace phs::analysis
