#include "measurement/standstill.h"

#include <algorithm>
#include <cmath>

namespace phs::measurement {

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

}  // namespace phs::measurement
