#include "measurement/series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace phs::measurement {

double Mean(std::span<const double> y) {
  double sum = 0;
  for (const double v : y) sum += v;
  return y.empty() ? 0 : sum / static_cast<double>(y.size());
}

double StandardDeviation(std::span<const double> y) {
  const double mean = Mean(y);
  double sum = 0;
  for (const double v : y) sum += (v - mean) * (v - mean);
  return y.empty() ? 0 : std::sqrt(sum / static_cast<double>(y.size()));
}

double Quantile(std::vector<double> y, double share) {
  if (y.empty()) return std::numeric_limits<double>::quiet_NaN();
  const size_t k = static_cast<size_t>(std::lround(share * static_cast<double>(y.size() - 1)));
  std::nth_element(y.begin(), y.begin() + static_cast<long>(k), y.end());
  return y[k];
}

double RobustDeviation(const std::vector<double>& y) {
  const double median = Quantile(y, 0.5);
  std::vector<double> away(y.size());
  for (size_t i = 0; i < y.size(); ++i) away[i] = std::abs(y[i] - median);
  return 1.4826 * Quantile(std::move(away), 0.5);
}

bool ComesInBursts(const std::vector<double>& y) {
  constexpr double kMost = 0.75;
  if (y.empty()) return false;
  const double square = std::inner_product(y.begin(), y.end(), y.begin(), 0.0);
  const double robust = RobustDeviation(y);
  return (1 - kMost) * square / static_cast<double>(y.size()) > robust * robust;
}

std::vector<double> Autocorrelation(std::span<const double> y, int most) {
  const double mean = Mean(y);
  const long n = static_cast<long>(y.size());
  std::vector<double> rho;
  double variance = 0;
  for (const double v : y) variance += (v - mean) * (v - mean);
  for (long lag = 0; lag <= most && lag < n; ++lag) {
    double sum = 0;
    for (long i = lag; i < n; ++i) sum += (y[i] - mean) * (y[i - lag] - mean);
    rho.push_back(variance > 0 ? sum / variance : (lag == 0 ? 1 : 0));
  }
  return rho;
}

double CorrelationTime(std::span<const double> y) {
  const int n = static_cast<int>(y.size());
  if (n < 8) return 1;
  const double mean = Mean(y);
  double variance = 0;
  for (const double v : y) variance += (v - mean) * (v - mean);
  if (!(variance > 0)) return 1;
  auto rho = [&](int lag) {
    double sum = 0;
    for (int i = lag; i < n; ++i) sum += (y[i] - mean) * (y[i - lag] - mean);
    return sum / variance;
  };
  double sum = 0;
  for (int lag = 1; lag + 1 < n / 3 && lag < 4000; lag += 2) {
    const double pair = rho(lag) + rho(lag + 1);
    if (pair <= 0) break;
    sum += pair;
  }
  return std::max(1.0, 1 + 2 * sum);
}

std::vector<double> LowPass(const std::vector<double>& y, double step_s, double cut_Hz) {
  if (y.size() < 4 || !(cut_Hz > 0) || cut_Hz * step_s >= 0.5) return y;
  // Bilinear transform with the pass run twice: each pass is down 3 dB at cut_Hz.
  const double w = std::tan(M_PI * cut_Hz * step_s), c = 1 + M_SQRT2 * w + w * w;
  const double b0 = w * w / c, a1 = 2 * (w * w - 1) / c, a2 = (1 - M_SQRT2 * w + w * w) / c;
  auto pass = [&](const std::vector<double>& in) {
    std::vector<double> out(in.size());
    double x1 = in[0], x2 = in[0], y1 = in[0], y2 = in[0];
    for (size_t i = 0; i < in.size(); ++i) {
      out[i] = b0 * (in[i] + 2 * x1 + x2) - a1 * y1 - a2 * y2;
      x2 = x1;
      x1 = in[i];
      y2 = y1;
      y1 = out[i];
    }
    return out;
  };
  std::vector<double> once = pass(y);
  std::reverse(once.begin(), once.end());
  std::vector<double> twice = pass(once);
  std::reverse(twice.begin(), twice.end());
  return twice;
}

}  // namespace phs::measurement
