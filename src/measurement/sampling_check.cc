#include "measurement/sampling_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "measurement/series.h"

namespace phs::measurement {
namespace {

constexpr int kLength = 64, kHalf = kLength / 2, kQuarter = kLength / 4;
constexpr double kAboveNoise = 20, kMuch = 0.1;
using Powers = std::array<double, kHalf>;  ///< at k/64 of the rate

/// Power of a stretch at each frequency.
Powers PowersOf(const double* y) {
  const double slope = (y[kLength - 1] - y[0]) / (kLength - 1);
  double part[kLength];
  for (int i = 0; i < kLength; ++i) {
    const double hann = 0.5 * (1 - std::cos(2 * M_PI * (i + 0.5) / kLength));
    part[i] = hann * (y[i] - y[0] - slope * i);
  }
  Powers out{};
  for (int k = 1; k < kHalf; ++k) {
    double c = 0, s = 0;
    for (int i = 0; i < kLength; ++i) {
      c += part[i] * std::cos(2 * M_PI * k * i / kLength);
      s += part[i] * std::sin(2 * M_PI * k * i / kLength);
    }
    out[static_cast<size_t>(k)] = c * c + s * s;
  }
  return out;
}

std::vector<Powers> PowersOf(const std::vector<double>& y, const std::vector<char>& bad) {
  std::vector<Powers> out;
  for (size_t i = 0; i + kLength <= y.size(); i += kLength) {
    const auto begin = bad.begin() + static_cast<long>(std::min(i, bad.size()));
    const auto end = bad.begin() + static_cast<long>(std::min(i + kLength, bad.size()));
    if (std::find(begin, end, 1) == end) out.push_back(PowersOf(&y[i]));
  }
  return out;
}

/// The least mean of three neighbours between a quarter and half of the rate.
double Least(const Powers& p) {
  double least = 1e300;
  for (size_t k = kQuarter; k + 2 < kHalf; ++k) {
    least = std::min(least, (p[k] + p[k + 1] + p[k + 2]) / 3);
  }
  return least;
}

/// At every frequency the power of the median stretch.
Powers MedianOf(const std::vector<Powers>& stretches) {
  Powers out{};
  for (size_t k = 1; k < kHalf; ++k) {
    std::vector<double> each;
    for (const Powers& p : stretches) each.push_back(p[k]);
    out[k] = Quantile(each, 0.5);
  }
  return out;
}

}  // namespace

FastMotion FindFastMotion(const std::vector<double>& position, const std::vector<char>& bad,
                          double step_s) {
  const std::vector<Powers> stretches = PowersOf(position, bad);
  if (stretches.empty()) return {};
  const double usual = Least(MedianOf(stretches));
  Powers all{};
  double judged = 0, fast = 0;
  for (const Powers& p : stretches) {
    const double noise = std::max(usual, Least(p));
    double below = 0, above = 0, of_noise = 0;
    for (size_t k = 1; k < kHalf; ++k) {
      const auto square = static_cast<double>(k * k);
      (k < kQuarter ? below : above) += square * (p[k] - noise);
      of_noise += square * noise;
    }
    if (!(below + above > kAboveNoise * of_noise)) continue;
    ++judged, fast += above > kMuch * (below + above);
    for (size_t k = 1; k < kHalf; ++k) {
      all[k] += static_cast<double>(k * k) * std::max(0.0, p[k] - noise);
    }
  }
  if (judged == 0) return {};
  double sum = 0, part = 0;
  for (const double p : all) sum += p;
  size_t reach = 0;
  while (reach + 1 < kHalf && part + all[reach] < 0.95 * sum) part += all[reach++];
  return {fast / judged, static_cast<double>(reach) / (kLength * step_s)};
}

Status CheckSampling(const Channel& input, const RigRun& run, std::vector<DataFinding>* findings) {
  const FastMotion fast = FindFastMotion(input.y, input.bad, run.step_s);
  if (fast.share < kMuch) return {};
  const std::string text = fmt::format(
      "moves faster than a quarter of its {:.4g} Hz of sampling for {:.0f} % of its time in motion",
      1 / run.step_s, 100 * fast.share);
  if (fast.share <= 0.5) {
    findings->push_back({input.name, text + ": what it does between the samples is not known"});
    return {};
  }
  return Error{run.source, input.name + " " + text, "motion below a quarter",
               fmt::format("sample at {:.2g} Hz or more, or low_pass_Hz: {:.2g}",
                           4 * fast.reaches_Hz, 0.2 / run.step_s)};
}

}  // namespace phs::measurement
