#include "measurement/motion_smoother.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace phs::measurement {
namespace {

constexpr int kHalfWindow = 20;  // samples over which a filter must prove itself

// A motion whose N-th derivative is white. One sample as time unit, the noise as length unit.
template <int N>
class Chain {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  struct Estimate {
    Vector mean;
    Matrix covariance;
  };

  Chain() {
    double factorial[N] = {1};
    for (int i = 1; i < N; ++i) factorial[i] = i * factorial[i - 1];
    transition_.setZero();
    for (int i = 0; i < N; ++i) {
      for (int j = i; j < N; ++j) transition_(i, j) = 1 / factorial[j - i];
      for (int j = 0; j < N; ++j) {
        driven_(i, j) = 1 / (factorial[N - 1 - i] * factorial[N - 1 - j] * (2 * N - 1 - i - j));
      }
    }
  }

  static Estimate Start(double y) {
    Estimate at{Vector::Zero(), Matrix::Zero()};
    at.mean[0] = y;
    at.covariance.diagonal().setConstant(1e6);
    at.covariance(0, 0) = 1;
    return at;
  }

  // One step on, white noise of strength q driving the N-th derivative.
  void Predict(double q, Estimate* at) const {
    at->mean = (transition_ * at->mean).eval();
    at->covariance = (transition_ * at->covariance * transition_.transpose()).eval();
    at->covariance += q * driven_;
  }

  // Takes in one sample, in Joseph's form, which keeps the covariance positive; its log likelihood.
  static double Update(double y, Estimate* at) {
    const double S = at->covariance(0, 0) + 1, error = y - at->mean[0];
    const Vector gain = at->covariance.col(0) / S;
    at->mean += gain * error;
    Matrix left = Matrix::Identity();
    left.col(0) -= gain;
    at->covariance = (left * at->covariance * left.transpose() + gain * gain.transpose()).eval();
    return -0.5 * (error * error / S + std::log(S));
  }

  const Matrix& transition() const { return transition_; }

 private:
  Matrix transition_, driven_;
};

// Strengths of a bank [noise units per sample^N, squared]: how many, the weakest, and decades
// between them.
template <int N>
struct Bank;
template <>
struct Bank<3> {
  static constexpr int kCount = 11;
  static constexpr double kWeakest = 1e-12, kDecades = 1.5;
};
template <>
struct Bank<5> {
  static constexpr int kCount = 9;
  static constexpr double kWeakest = 1e-14, kDecades = 2.25;
};
template <>
struct Bank<7> {
  static constexpr int kCount = 9;
  static constexpr double kWeakest = 1e-20, kDecades = 3.2;
};

// What the data say of a bank of filters at every sample.
struct BankView {
  std::vector<double> strength;  // mean of log q under the local evidence for each, as q
  std::vector<double> evidence;  // ln of the sum of their local likelihoods
};

template <int N>
BankView ViewBank(const std::vector<double>& y, const std::vector<char>& bad) {
  const Chain<N> chain;
  const long n = static_cast<long>(y.size());
  constexpr int kCount = Bank<N>::kCount;
  double q[kCount];
  std::vector<std::vector<double>> sums;  // log likelihood of all samples before
  for (int k = 0; k < kCount; ++k) {
    q[k] = Bank<N>::kWeakest * std::pow(10.0, Bank<N>::kDecades * k);
    std::vector<double> sum(y.size() + 1, 0.0);
    typename Chain<N>::Estimate at = Chain<N>::Start(y[0]);
    for (size_t i = 0; i < y.size(); ++i) {
      if (i > 0) chain.Predict(q[k], &at);
      sum[i + 1] = sum[i] + (bad.empty() || !bad[i] ? Chain<N>::Update(y[i], &at) : 0);
    }
    sums.push_back(std::move(sum));
  }
  BankView view;
  for (long i = 0; i < n; ++i) {
    const auto low = static_cast<size_t>(std::max(0L, i - kHalfWindow));
    const auto high = static_cast<size_t>(std::min(n, i + kHalfWindow + 1));
    double evidence[kCount], most = -1e300;
    for (int k = 0; k < kCount; ++k) {
      evidence[k] = sums[k][high] - sums[k][low];
      most = std::max(most, evidence[k]);
    }
    double weight = 0, logarithm = 0;
    for (int k = 0; k < kCount; ++k) {
      const double w = std::exp(evidence[k] - most);
      weight += w;
      logarithm += w * std::log(q[k]);
    }
    view.strength.push_back(std::exp(logarithm / weight));
    view.evidence.push_back(most + std::log(weight));
  }
  return view;
}

// Rauch-Tung-Striebel smoother with strength q at every sample; in units of noise and samples.
template <int N>
SmoothMotion SmoothBy(const std::vector<double>& y, const std::vector<char>& bad,
                      const std::vector<double>& q) {
  using Estimate = typename Chain<N>::Estimate;
  using Matrix = typename Chain<N>::Matrix;
  const Chain<N> chain;
  const size_t n = y.size();
  std::vector<Estimate> predicted, filtered;
  Estimate at = Chain<N>::Start(y[0]);
  for (size_t i = 0; i < n; ++i) {
    if (i > 0) chain.Predict(q[i], &at);
    predicted.push_back(at);
    if (bad.empty() || !bad[i]) Chain<N>::Update(y[i], &at);
    filtered.push_back(at);
  }
  SmoothMotion out;
  for (auto* row : {&out.position, &out.speed, &out.acceleration, &out.position_deviation,
                    &out.speed_deviation}) {
    row->assign(n, 0.0);
  }
  for (size_t i = n; i-- > 0;) {
    if (i + 1 < n) {
      // G = P_f F' P_p^-1 through a factorisation of the symmetric P_p.
      const Estimate& next = predicted[i + 1];
      const Matrix G =
          next.covariance.ldlt().solve(chain.transition() * filtered[i].covariance).transpose();
      at.mean = (filtered[i].mean + G * (at.mean - next.mean)).eval();
      at.covariance =
          (filtered[i].covariance + G * (at.covariance - next.covariance) * G.transpose()).eval();
    }
    out.position[i] = at.mean[0], out.speed[i] = at.mean[1], out.acceleration[i] = at.mean[2];
    out.position_deviation[i] = std::sqrt(std::max(at.covariance(0, 0), 0.0));
    out.speed_deviation[i] = std::sqrt(std::max(at.covariance(1, 1), 0.0));
  }
  return out;
}

// A smoothed motion and its share of the whole at every sample.
struct Part {
  SmoothMotion motion;
  std::vector<double> share;  // at first ln of its evidence
};

template <int N>
Part SmoothByBank(const std::vector<double>& y, const std::vector<char>& bad) {
  BankView view = ViewBank<N>(y, bad);
  return {SmoothBy<N>(y, bad, view.strength), std::move(view.evidence)};
}

// Stretches of samples [begin, end) between gaps that a smooth motion is not carried across, none
// so long that its covariances take more than 30 MB.
std::vector<std::pair<size_t, size_t>> FindStretches(size_t count, const std::vector<char>& bad) {
  constexpr size_t kBridged = 8, kShortest = 2 * static_cast<size_t>(kHalfWindow), kLongest = 32768;
  std::vector<std::pair<size_t, size_t>> out;
  size_t begin = 0, end = 0;  // of the stretch, after its last good sample
  const auto close = [&](size_t next) {
    if (end - begin >= kShortest) out.emplace_back(begin, end);
    begin = end = next;
  };
  for (size_t i = 0; i < count; ++i) {
    if (!bad.empty() && bad[i]) continue;
    if (i - end > kBridged || i - begin >= kLongest) close(i);
    end = i + 1;
  }
  close(count);
  return out;
}

// Stretch by stretch; elsewhere as `whole`, with no share.
template <int N>
Part SmoothByStretches(const std::vector<double>& y, const std::vector<char>& bad,
                       const Part& whole) {
  constexpr double kNone = -1e300;
  Part out{whole.motion, std::vector<double>(y.size(), kNone)};
  for (const auto& [begin, end] : FindStretches(y.size(), bad)) {
    const auto from = static_cast<long>(begin), to = static_cast<long>(end);
    const std::vector<double> here(y.begin() + from, y.begin() + to);
    std::vector<char> not_good;
    if (!bad.empty()) not_good.assign(bad.begin() + from, bad.begin() + to);
    const Part part = SmoothByBank<N>(here, not_good);
    const auto place = [from](const std::vector<double>& row, std::vector<double>* all) {
      std::copy(row.begin(), row.end(), all->begin() + from);
    };
    place(part.share, &out.share);
    place(part.motion.position, &out.motion.position);
    place(part.motion.speed, &out.motion.speed);
    place(part.motion.acceleration, &out.motion.acceleration);
    place(part.motion.position_deviation, &out.motion.position_deviation);
    place(part.motion.speed_deviation, &out.motion.speed_deviation);
  }
  return out;
}

void SetShares(std::vector<Part>* parts) {
  for (size_t i = 0; i < parts->front().share.size(); ++i) {
    double most = -1e300, sum = 0;
    for (const Part& part : *parts) most = std::max(most, part.share[i]);
    for (Part& part : *parts) sum += part.share[i] = std::exp(part.share[i] - most);
    for (Part& part : *parts) part.share[i] /= sum;
  }
}

// The parts as one motion about the first: where a share changes, so does the speed.
SmoothMotion Blend(const std::vector<Part>& parts) {
  const SmoothMotion& first = parts.front().motion;
  SmoothMotion out = first;
  const size_t n = first.position.size();
  for (size_t i = 0; i < n; ++i) {
    const size_t before = i > 0 ? i - 1 : i, after = i + 1 < n ? i + 1 : i;
    for (const Part& part : parts) {
      const SmoothMotion& m = part.motion;
      const double share = part.share[i];
      const double rate = after > before ? (part.share[after] - part.share[before]) /
                                               static_cast<double>(after - before)
                                         : 0;
      const double apart = m.position[i] - first.position[i], faster = m.speed[i] - first.speed[i];
      out.position[i] += share * apart;
      out.speed[i] += share * faster + rate * apart;
      out.acceleration[i] +=
          share * (m.acceleration[i] - first.acceleration[i]) + 2 * rate * faster;
    }
    double position_square = 0, speed_square = 0;  // about the blend
    for (const Part& part : parts) {
      const SmoothMotion& m = part.motion;
      const double off = m.position[i] - out.position[i], faster = m.speed[i] - out.speed[i];
      position_square += part.share[i] * (std::pow(m.position_deviation[i], 2) + off * off);
      speed_square += part.share[i] * (std::pow(m.speed_deviation[i], 2) + faster * faster);
    }
    out.position_deviation[i] = std::sqrt(position_square);
    out.speed_deviation[i] = std::sqrt(speed_square);
  }
  return out;
}

}  // namespace

SmoothMotion SmoothPosition(const std::vector<double>& samples, const std::vector<char>& bad,
                            double step_s, double noise) {
  const size_t n = samples.size();
  if (n == 0) return {};
  std::vector<double> y(n);
  const double origin = samples[0];
  for (size_t i = 0; i < n; ++i) y[i] = (samples[i] - origin) / noise;
  std::vector<Part> parts;
  parts.push_back(SmoothByBank<3>(y, bad));
  parts.push_back(SmoothByStretches<5>(y, bad, parts.front()));
  parts.push_back(SmoothByStretches<7>(y, bad, parts.front()));
  SetShares(&parts);
  SmoothMotion out = Blend(parts);
  for (size_t i = 0; i < n; ++i) {
    out.position[i] = origin + noise * out.position[i];
    out.speed[i] *= noise / step_s, out.speed_deviation[i] *= noise / step_s;
    out.acceleration[i] *= noise / (step_s * step_s);
    out.position_deviation[i] *= noise;
  }
  return out;
}

}  // namespace phs::measurement
