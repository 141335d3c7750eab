#include "analysis/running_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "base/check.h"

namespace phs::analysis {
namespace {

/// Second-order section y = (b0 x + b1 x' + b2 x'') - (a1 y' + a2 y'').
struct Section {
  double b0, b1, b2, a1, a2;
};

/// Section of a Butterworth filter with quality 1/(2 cos angle); k = tan(pi cut-off interval).
Section MakeSection(double k, double damping, bool high) {
  const double a0 = 1 + 2 * damping * k + k * k;
  const double b0 = high ? 1 / a0 : k * k / a0;
  return {b0, high ? -2 * b0 : 2 * b0, b0, 2 * (k * k - 1) / a0,
          (1 - 2 * damping * k + k * k) / a0};
}

void Run(const Section& s, bool high, std::vector<double>* signal) {
  double x1 = signal->front();
  double x2 = x1;
  double y1 = high ? 0 : x1;  // steady state of a constant
  double y2 = y1;
  for (double& value : *signal) {
    const double x = value;
    const double y = s.b0 * x + s.b1 * x1 + s.b2 * x2 - s.a1 * y1 - s.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    value = y;
  }
}

Result<std::vector<double>> Filter(const std::vector<double>& signal, double interval_s,
                                   double cutoff_Hz, bool high) {
  if (!(interval_s > 0)) {
    return Error{"sampling interval", "is " + std::to_string(interval_s) + " s", "> 0", ""};
  }
  if (!(cutoff_Hz > 0 && cutoff_Hz < 0.5 / interval_s)) {
    return Error{
        "cut-off frequency", "is " + std::to_string(cutoff_Hz) + " Hz",
        "between 0 and half the sampling rate, " + std::to_string(0.5 / interval_s) + " Hz",
        "record at shorter intervals"};
  }
  std::vector<double> out = signal;
  if (out.empty()) return out;
  const double k = std::tan(std::numbers::pi * cutoff_Hz * interval_s);
  for (const double angle : {std::numbers::pi / 8, 3 * std::numbers::pi / 8}) {
    Run(MakeSection(k, std::cos(angle), high), high, &out);
  }
  return out;
}

/// Integral of the signal from the first place to `place`; `at` is a sample at or before it.
double IntegralTo(const std::vector<double>& distance, const std::vector<double>& signal,
                  const std::vector<double>& integral, double place, std::size_t* at) {
  while (*at + 2 < distance.size() && distance[*at + 1] <= place) ++*at;
  const std::size_t i = *at;
  const double way = place - distance[i];
  if (!(way > 0)) return integral[i];
  const double slope = (signal[i + 1] - signal[i]) / (distance[i + 1] - distance[i]);
  return integral[i] + way * (signal[i] + 0.5 * slope * way);
}

}  // namespace

Result<std::vector<double>> LowPass(const std::vector<double>& signal, double interval_s,
                                    double cutoff_Hz) {
  return Filter(signal, interval_s, cutoff_Hz, false);
}

Result<std::vector<double>> HighPass(const std::vector<double>& signal, double interval_s,
                                     double cutoff_Hz) {
  return Filter(signal, interval_s, cutoff_Hz, true);
}

Result<std::vector<double>> BandPass(const std::vector<double>& signal, double interval_s,
                                     double low_Hz, double high_Hz) {
  auto high = HighPass(signal, interval_s, low_Hz);
  if (!high.ok()) return high;
  return LowPass(high.value(), interval_s, high_Hz);
}

Result<std::vector<double>> SlidingMean(const std::vector<double>& distance,
                                        const std::vector<double>& signal, double window_m,
                                        double step_m) {
  PHS_CHECK(distance.size() == signal.size());
  if (!(window_m > 0) || !(step_m > 0)) {
    return Error{"sliding mean", "window or step is not positive", "> 0 m", ""};
  }
  std::vector<double> integral(distance.size(), 0.0);
  for (std::size_t i = 1; i < distance.size(); ++i) {
    const double way = distance[i] - distance[i - 1];
    if (!(way >= 0)) {
      return Error{"sliding mean", "the vehicle runs back at " + std::to_string(distance[i]) + " m",
                   "distance that never falls", ""};
    }
    integral[i] = integral[i - 1] + 0.5 * way * (signal[i] + signal[i - 1]);
  }
  std::vector<double> means;
  if (distance.size() < 2) return means;
  std::size_t begin = 0;
  std::size_t end = 0;
  // Rounding must not cost the last window.
  const double last = distance.back() - window_m + 1e-9 * window_m;
  for (int k = 0; distance[0] + k * step_m <= last; ++k) {
    const double from = distance[0] + k * step_m;
    const double to = IntegralTo(distance, signal, integral, from + window_m, &end);
    means.push_back((to - IntegralTo(distance, signal, integral, from, &begin)) / window_m);
  }
  return means;
}

Result<std::vector<double>> SlidingRms(const std::vector<double>& distance,
                                       const std::vector<double>& signal, double window_m,
                                       double step_m) {
  std::vector<double> squares = signal;
  for (double& value : squares) value *= value;
  auto means = SlidingMean(distance, squares, window_m, step_m);
  if (!means.ok()) return means;
  for (double& value : means.value()) value = std::sqrt(std::max(0.0, value));
  return means;
}

double Percentile(std::vector<double> samples, double percent) {
  PHS_CHECK(percent >= 0 && percent <= 100);
  if (samples.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(samples.begin(), samples.end());
  const double rank = percent / 100 * static_cast<double>(samples.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, samples.size() - 1);
  return samples[below] + (rank - static_cast<double>(below)) * (samples[above] - samples[below]);
}

}  // namespace phs::analysis
