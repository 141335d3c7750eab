#include "measurement/channel_noise.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "measurement/series.h"
#include "measurement/time_wave.h"

namespace phs::measurement {
namespace {

constexpr int kBlock = 40;        // samples over which noise is taken as even
constexpr double kTrendTime = 1;  // [s] stretches at rest are levelled over this time

/// Takes the strongest wave out where that is most of what is there: a vibration is no noise but
/// something to be explained.
void TakeOutVibration(std::vector<double>* y) {
  constexpr double kMost = 0.75;
  const auto n = static_cast<Eigen::Index>(y->size());
  const double cycles = FindTimeWave(*y, 1).frequency_Hz;
  const Eigen::ArrayXd phase = 2 * M_PI * cycles * Eigen::ArrayXd::LinSpaced(n, 0, n - 1);
  Eigen::MatrixXd wave(n, 2);
  wave << phase.sin().matrix(), phase.cos().matrix();
  Eigen::Map<Eigen::VectorXd> all(y->data(), n);
  const Eigen::VectorXd left = all - wave * wave.colPivHouseholderQr().solve(all);
  if (left.squaredNorm() < (1 - kMost) * all.squaredNorm()) all = left;
}

}  // namespace

double WhiteNoise(const std::vector<double>& y, const std::vector<char>& bad) {
  // Fourth difference 1, -4, 6, -4, 1: variance 70 sigma².
  std::vector<double> blocks;
  double sum = 0;
  int count = 0;
  for (size_t i = 2; i + 2 < y.size(); ++i) {
    bool good = true;
    for (size_t j = i - 2; j <= i + 2 && !bad.empty(); ++j) good = good && !bad[j];
    if (good) {
      const double d = y[i - 2] - 4 * y[i - 1] + 6 * y[i] - 4 * y[i + 1] + y[i + 2];
      sum += d * d / 70;
      ++count;
    }
    if (static_cast<int>(i) % kBlock == 0) {
      if (count > kBlock / 2) blocks.push_back(sum / count);
      sum = count = 0;
    }
  }
  if (blocks.empty()) return 0;
  std::sort(blocks.begin(), blocks.end());
  // Mean of the quieter half; its bias for pure noise (blocks of forty squared, correlated
  // differences: relative spread about 0.35) is taken out.
  const size_t half = std::max<size_t>(1, blocks.size() / 2);
  double quiet = 0;
  for (size_t i = 0; i < half; ++i) quiet += blocks[i];
  quiet /= static_cast<double>(half);
  return std::sqrt(quiet / 0.74);
}

double Quantum(const std::vector<double>& y) {
  std::vector<double> sorted = y;
  std::sort(sorted.begin(), sorted.end());
  const double span = sorted.empty() ? 0 : sorted.back() - sorted.front();
  if (!(span > 0)) return 0;
  double smallest = span;
  for (size_t i = 1; i < sorted.size(); ++i) {
    const double step = sorted[i] - sorted[i - 1];
    if (step > 1e-9 * span) smallest = std::min(smallest, step);
  }
  if (span / smallest > 1e7) return 0;
  int off = 0;
  for (size_t i = 1; i < sorted.size(); ++i) {
    const double steps = (sorted[i] - sorted[i - 1]) / smallest;
    off += std::abs(steps - std::round(steps)) > 0.05 + 1e-3 * steps;
  }
  return off * 100 < static_cast<int>(sorted.size()) ? smallest : 0;
}

double LeastNoise(const std::vector<double>& y) {
  const auto [low, high] = std::minmax_element(y.begin(), y.end());
  return y.empty() ? 0 : 1e-6 * (*high - *low);
}

ChannelNoise EstimateNoise(const Channel& channel, const std::vector<char>& rest, double step_s) {
  ChannelNoise noise;
  noise.quantum = Quantum(channel.y);
  const double rounding = noise.quantum / std::sqrt(12.0);
  noise.white = std::max({WhiteNoise(channel.y, channel.bad), rounding, LeastNoise(channel.y)});
  noise.level = noise.white;
  const size_t stretch = static_cast<size_t>(std::max(16.0, kTrendTime / step_s));
  std::vector<double> squares, times;
  for (size_t begin = 0; begin + stretch <= rest.size();) {
    size_t i = begin;
    while (i < begin + stretch && rest[i] && !channel.bad[i]) ++i;
    if (i < begin + stretch) {
      begin = i + 1;
      continue;
    }
    double s1 = 0, s2 = 0, mean = 0;
    const double middle = 0.5 * static_cast<double>(stretch - 1);
    for (size_t j = 0; j < stretch; ++j) mean += channel.y[begin + j];
    mean /= static_cast<double>(stretch);
    for (size_t j = 0; j < stretch; ++j) {
      const double u = static_cast<double>(j) - middle;
      s1 += u * (channel.y[begin + j] - mean);
      s2 += u * u;
    }
    std::vector<double> left(stretch);
    for (size_t j = 0; j < stretch; ++j) {
      const double u = static_cast<double>(j) - middle;
      left[j] = channel.y[begin + j] - mean - s1 / s2 * u;
    }
    TakeOutVibration(&left);
    // Blows from beside the rig are no more its noise than a vibration is.
    const double sum = std::inner_product(left.begin(), left.end(), left.begin(), 0.0);
    squares.push_back(ComesInBursts(left) ? std::pow(RobustDeviation(left), 2)
                                          : sum / static_cast<double>(stretch - 2));
    times.push_back(CorrelationTime(left));
    begin += stretch;
  }
  if (squares.size() >= 3) {
    // The median stretch: one in which the oil still settles does not count.
    noise.level = std::max(noise.white, std::sqrt(Quantile(squares, 0.5)));
    noise.correlation_samples = Quantile(times, 0.5);
  }
  return noise;
}

}  // namespace phs::measurement
