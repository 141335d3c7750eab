#include "identify/motion_smoother.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace phs::identify {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Strengths of the bank: jerk variance per step, in noise units per sample³.
constexpr int kBank = 11;
constexpr double kWeakest = 1e-12, kDecades = 1.5;
constexpr int kHalfWindow = 20;  // samples over which a strength must prove itself

double Strength(int k) { return kWeakest * std::pow(10.0, kDecades * k); }

// One sample as time unit, the noise as length unit.
struct Prediction {
  Vector3d mean;
  Matrix3d covariance;
};

const Matrix3d& Transition() {
  static const Matrix3d F = (Matrix3d() << 1, 1, 0.5, 0, 1, 1, 0, 0, 1).finished();
  return F;
}

// Covariance of one step of white jerk of unit strength.
const Matrix3d& JerkCovariance() {
  static const Matrix3d Q =
      (Matrix3d() << 1.0 / 20, 1.0 / 8, 1.0 / 6, 1.0 / 8, 1.0 / 3, 1.0 / 2, 1.0 / 6, 1.0 / 2, 1.0)
          .finished();
  return Q;
}

void Predict(double q, Vector3d* mean, Matrix3d* P) {
  const Matrix3d& F = Transition();
  *mean = F * *mean;
  *P = F * *P * F.transpose() + q * JerkCovariance();
}

/// Takes in one sample; returns its log likelihood.
double Update(double y, Vector3d* mean, Matrix3d* P) {
  const double S = (*P)(0, 0) + 1, error = y - (*mean)[0];
  const Vector3d gain = P->col(0) / S;
  *mean += gain * error;
  *P -= gain * P->row(0);
  *P = (0.5 * (*P + P->transpose())).eval();
  return -0.5 * (error * error / S + std::log(S));
}

Matrix3d StartCovariance() { return Vector3d(1, 1e6, 1e6).asDiagonal(); }

/// Log likelihood of every sample given those before it.
std::vector<double> Likelihoods(const std::vector<double>& y, const std::vector<char>& bad,
                                double q) {
  std::vector<double> out(y.size(), 0.0);
  Vector3d mean(y[0], 0, 0);
  Matrix3d P = StartCovariance();
  for (size_t i = 0; i < y.size(); ++i) {
    if (i > 0) Predict(q, &mean, &P);
    if (bad.empty() || !bad[i]) out[i] = Update(y[i], &mean, &P);
  }
  return out;
}

/// Strength at every sample: mean of log q under the local evidence for each.
std::vector<double> LocalStrength(const std::vector<double>& y, const std::vector<char>& bad) {
  const long n = static_cast<long>(y.size());
  std::vector<std::vector<double>> sums;
  for (int k = 0; k < kBank; ++k) {
    const std::vector<double> one = Likelihoods(y, bad, Strength(k));
    std::vector<double> sum(y.size() + 1, 0.0);
    for (size_t i = 0; i < one.size(); ++i) sum[i + 1] = sum[i] + one[i];
    sums.push_back(std::move(sum));
  }
  std::vector<double> q(y.size());
  for (long i = 0; i < n; ++i) {
    const size_t low = static_cast<size_t>(std::max(0L, i - kHalfWindow));
    const size_t high = static_cast<size_t>(std::min(n, i + kHalfWindow + 1));
    double evidence[kBank], most = -1e300;
    for (int k = 0; k < kBank; ++k) {
      evidence[k] = sums[static_cast<size_t>(k)][high] - sums[static_cast<size_t>(k)][low];
      most = std::max(most, evidence[k]);
    }
    double weight = 0, logarithm = 0;
    for (int k = 0; k < kBank; ++k) {
      const double w = std::exp(evidence[k] - most);
      weight += w;
      logarithm += w * std::log(Strength(k));
    }
    q[static_cast<size_t>(i)] = std::exp(logarithm / weight);
  }
  return q;
}

}  // namespace

SmoothMotion SmoothPosition(const std::vector<double>& samples, const std::vector<char>& bad,
                            double step_s, double noise) {
  const size_t n = samples.size();
  SmoothMotion out;
  for (auto* row : {&out.position, &out.speed, &out.acceleration, &out.position_deviation,
                    &out.speed_deviation}) {
    row->assign(n, 0.0);
  }
  if (n == 0) return out;
  std::vector<double> y(n);
  const double origin = samples[0];
  for (size_t i = 0; i < n; ++i) y[i] = (samples[i] - origin) / noise;
  const std::vector<double> q = LocalStrength(y, bad);
  std::vector<Prediction> predicted(n), filtered(n);
  Vector3d mean(y[0], 0, 0);
  Matrix3d P = StartCovariance();
  for (size_t i = 0; i < n; ++i) {
    if (i > 0) Predict(q[i], &mean, &P);
    predicted[i] = {mean, P};
    if (bad.empty() || !bad[i]) Update(y[i], &mean, &P);
    filtered[i] = {mean, P};
  }
  for (size_t i = n; i-- > 0;) {
    if (i + 1 < n) {
      // G = P_f F' P_p^-1 through a factorisation of the symmetric P_p.
      const Matrix3d G = predicted[i + 1]
                             .covariance.ldlt()
                             .solve(Transition() * filtered[i].covariance)
                             .transpose();
      mean = filtered[i].mean + G * (mean - predicted[i + 1].mean);
      P = filtered[i].covariance + G * (P - predicted[i + 1].covariance) * G.transpose();
    }
    out.position[i] = origin + noise * mean[0];
    out.speed[i] = noise / step_s * mean[1];
    out.acceleration[i] = noise / (step_s * step_s) * mean[2];
    out.position_deviation[i] = noise * std::sqrt(std::max(P(0, 0), 0.0));
    out.speed_deviation[i] = noise / step_s * std::sqrt(std::max(P(1, 1), 0.0));
  }
  return out;
}

std::vector<char> FindRest(const SmoothMotion& motion, double step_s, double widths,
                           double slowest_m_s, double shortest_s) {
  const size_t n = motion.speed.size();
  std::vector<char> rest(n, 0);
  const size_t shortest = static_cast<size_t>(std::max(2.0, shortest_s / step_s));
  size_t begin = 0;
  for (size_t i = 0; i <= n; ++i) {
    const bool still = i < n && std::abs(motion.speed[i]) <=
                                    std::max(widths * motion.speed_deviation[i], slowest_m_s);
    if (still) continue;
    if (i - begin >= shortest) {
      std::fill(rest.begin() + static_cast<long>(begin), rest.begin() + static_cast<long>(i), 1);
    }
    begin = i + 1;
  }
  return rest;
}

std::vector<char> FindStandstill(const std::vector<double>& samples, const std::vector<char>& bad,
                                 double step_s, double noise) {
  constexpr double kStretch_s = 1, kWidths = 4, kMoreThanNoise = 2;
  const size_t count = static_cast<size_t>(std::max(16.0, kStretch_s / step_s));
  const double n = static_cast<double>(count), middle = 0.5 * (n - 1);
  const double spread = n * (n * n - 1) / 12;  // sum of (j - middle)²
  std::vector<char> still(samples.size(), 0);
  for (size_t begin = 0; begin + count <= samples.size(); begin += count / 4) {
    double mean = 0, slope = 0, square = 0;
    bool good = true;
    for (size_t j = 0; j < count; ++j) {
      mean += samples[begin + j] / n;
      good = good && (bad.empty() || !bad[begin + j]);
    }
    for (size_t j = 0; j < count; ++j) {
      const double from_mean = samples[begin + j] - mean;
      slope += (static_cast<double>(j) - middle) * from_mean / spread;
      square += from_mean * from_mean;
    }
    const double left = (square - slope * slope * spread) / (n - 2);
    if (!good || std::abs(slope) > kWidths * noise / std::sqrt(spread)) continue;
    if (left > kMoreThanNoise * noise * noise) continue;
    std::fill_n(still.begin() + static_cast<long>(begin), count, 1);
  }
  return still;
}

}  // namespace phs::identify
