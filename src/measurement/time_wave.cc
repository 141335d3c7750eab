#include "measurement/time_wave.h"

#include <bit>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

namespace phs::measurement {
namespace {

constexpr size_t kPadding = 4;

double Power(const std::vector<double>& y, double cycles_per_sample) {
  const std::complex<double> turn = std::polar(1.0, 2 * M_PI * cycles_per_sample);
  std::complex<double> sum = 0, at = 1;
  for (const double value : y) sum += value * at, at *= turn;
  return std::norm(sum);
}

}  // namespace

TimeWave FindTimeWave(const std::vector<double>& weighted, double step_s, double least_periods) {
  constexpr double kMost = 0.45;
  const auto n = static_cast<double>(weighted.size());
  TimeWave out;
  if (n < 32) return out;
  std::vector<double> padded = weighted;
  // A power of two: a length with a large prime factor takes as long as its square.
  padded.resize(std::bit_ceil(kPadding * weighted.size()), 0.0);
  Eigen::FFT<double> transform;
  std::vector<std::complex<double>> lines;
  transform.fwd(lines, padded);
  const double width = 1 / static_cast<double>(padded.size());  // between lines, cycles per sample
  const auto first = static_cast<size_t>(std::ceil(least_periods / n / width));
  const auto last = static_cast<size_t>(kMost / width);
  if (first > last) return out;
  size_t highest = first;
  for (size_t k = first; k <= last; ++k) {
    if (std::norm(lines[k]) > std::norm(lines[highest])) highest = k;
  }
  double best = width * static_cast<double>(highest), power = Power(weighted, best);
  for (double fine = 0.5 * width; fine > 1e-4 * width; fine *= 0.5) {
    for (const double at : {best - fine, best + fine}) {
      if (const double now = Power(weighted, at); now > power) best = at, power = now;
    }
  }
  out.frequency_Hz = best / step_s;
  out.looked_at = static_cast<double>(last - first) * width * n;
  return out;
}

}  // namespace phs::measurement
