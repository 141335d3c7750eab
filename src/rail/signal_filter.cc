#include "rail/signal_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace phs::rail {
namespace {

enum class Pass { kLow, kHigh };

/// y = b0 x + b1 x1 + b2 x2 - a1 y1 - a2 y2.
struct Section {
  double b0, b1, b2, a1, a2;
};

/// Analog prototype 1/(s^2 + s/q + 1) (low) or s^2/(…) (high), s = (1 - z)/(k (1 + z)), z = delay,
/// k = tan(pi fc/fs).
Section MakeSection(Pass pass, double k, double q) {
  const double norm = 1 / (1 + k / q + k * k);
  const double a1 = 2 * (k * k - 1) * norm;
  const double a2 = (1 - k / q + k * k) * norm;
  if (pass == Pass::kLow) {
    const double b = k * k * norm;
    return {b, 2 * b, b, a1, a2};
  }
  return {norm, -2 * norm, norm, a1, a2};
}

void Apply(const Section& s, double steady_gain, std::vector<double>* samples) {
  double x1 = samples->front();
  double x2 = x1;
  double y1 = steady_gain * x1;
  double y2 = y1;
  for (double& value : *samples) {
    const double x = value;
    const double y = s.b0 * x + s.b1 * x1 + s.b2 * x2 - s.a1 * y1 - s.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    value = y;
  }
}

Result<std::vector<double>> Butterworth(Pass pass, std::vector<double> samples, double sample_rate,
                                        double cut_off) {
  if (samples.empty()) return Error{"filter", "has no samples", "at least one", ""};
  if (!(cut_off > 0 && cut_off < 0.5 * sample_rate)) {
    return Error{"filter", "cut-off " + std::to_string(cut_off) + " Hz",
                 "above 0 and below half the sample rate of " + std::to_string(sample_rate) + " Hz",
                 "record more often"};
  }
  const double k = std::tan(std::numbers::pi * cut_off / sample_rate);
  // Poles of order 4 lie at 22.5 and 67.5 degrees from the negative real axis.
  for (double angle : {22.5, 67.5}) {
    const double q = 1 / (2 * std::cos(angle * std::numbers::pi / 180));
    Apply(MakeSection(pass, k, q), pass == Pass::kLow ? 1 : 0, &samples);
  }
  return samples;
}

Status CheckChannel(const std::vector<double>& distance, const std::vector<double>& values,
                    double window, double step) {
  if (distance.size() != values.size()) {
    return Error{"sliding mean", "distance and channel differ in length", "equal lengths", ""};
  }
  if (!(window > 0) || !(step > 0)) {
    return Error{"sliding mean", "window or step is not positive", "lengths above 0 m", ""};
  }
  for (std::size_t i = 1; i < distance.size(); ++i) {
    if (!(distance[i] >= distance[i - 1])) {
      return Error{"sliding mean", "distance falls at sample " + std::to_string(i),
                   "a distance that never falls", ""};
    }
  }
  return {};
}

/// Integral over [distance[0], x] of a function whose integral over a piece with ends p, q and
/// length 1 is `piece(p, q)`.
class RunningIntegral {
 public:
  using Piece = double (*)(double, double);
  RunningIntegral(const std::vector<double>& x, const std::vector<double>& y, Piece piece)
      : x_(x), y_(y), piece_(piece), sum_(x.size(), 0.0) {
    for (std::size_t i = 1; i < x.size(); ++i) {
      sum_[i] = sum_[i - 1] + (x[i] - x[i - 1]) * piece(y[i - 1], y[i]);
    }
  }
  double To(double at) const {
    const auto above = std::upper_bound(x_.begin(), x_.end(), at);
    if (above == x_.begin()) return 0;
    const auto i = static_cast<std::size_t>(above - x_.begin()) - 1;
    if (i + 1 >= x_.size()) return sum_.back();
    const double part = (at - x_[i]) / (x_[i + 1] - x_[i]);
    return sum_[i] + (at - x_[i]) * piece_(y_[i], y_[i] + part * (y_[i + 1] - y_[i]));
  }

 private:
  const std::vector<double>& x_;
  const std::vector<double>& y_;
  Piece piece_;
  std::vector<double> sum_;
};

Result<std::vector<double>> Slide(const std::vector<double>& distance,
                                  const std::vector<double>& values, double window, double step,
                                  RunningIntegral::Piece piece) {
  const Status good = CheckChannel(distance, values, window, step);
  if (!good.ok()) return good.error();
  std::vector<double> means;
  if (distance.size() < 2) return means;
  const RunningIntegral integral(distance, values, piece);
  // A window that ends at the last sample counts although its end is rounded.
  const double room = distance.back() - distance.front() - window;
  if (room < -1e-9 * window) return means;
  const auto count = static_cast<long>(std::floor(room / step + 1e-9)) + 1;
  for (long k = 0; k < count; ++k) {
    const double from = distance.front() + static_cast<double>(k) * step;
    means.push_back((integral.To(from + window) - integral.To(from)) / window);
  }
  return means;
}

double MeanPiece(double p, double q) { return 0.5 * (p + q); }
double SquarePiece(double p, double q) { return (p * p + p * q + q * q) / 3; }

}  // namespace

Result<std::vector<double>> LowPass(const std::vector<double>& samples, double sample_rate,
                                    double cut_off) {
  return Butterworth(Pass::kLow, samples, sample_rate, cut_off);
}

Result<std::vector<double>> HighPass(const std::vector<double>& samples, double sample_rate,
                                     double cut_off) {
  return Butterworth(Pass::kHigh, samples, sample_rate, cut_off);
}

Result<std::vector<double>> BandPass(const std::vector<double>& samples, double sample_rate,
                                     double low, double high) {
  if (!(low < high)) {
    return Error{"filter",
                 "band from " + std::to_string(low) + " to " + std::to_string(high) + " Hz",
                 "a lower end below the upper", ""};
  }
  const auto above = HighPass(samples, sample_rate, low);
  if (!above.ok()) return above.error();
  return LowPass(above.value(), sample_rate, high);
}

Result<std::vector<double>> SlidingMean(const std::vector<double>& distance,
                                        const std::vector<double>& values, double window,
                                        double step) {
  return Slide(distance, values, window, step, MeanPiece);
}

Result<std::vector<double>> SlidingRms(const std::vector<double>& distance,
                                       const std::vector<double>& values, double window,
                                       double step) {
  auto means = Slide(distance, values, window, step, SquarePiece);
  if (!means.ok()) return means;
  for (double& mean : means.value()) mean = std::sqrt(std::max(0.0, mean));
  return means;
}

double Percentile(std::vector<double> samples, double percent) {
  if (samples.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(samples.begin(), samples.end());
  const double place =
      std::clamp(percent / 100, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= samples.size()) return samples.back();
  const double part = place - static_cast<double>(below);
  return samples[below] + part * (samples[below + 1] - samples[below]);
}

double PercentileSize(const std::vector<double>& samples, double percent) {
  return std::max(std::abs(Percentile(samples, percent)),
                  std::abs(Percentile(samples, 100 - percent)));
}

double Rms(const std::vector<double>& samples) {
  if (samples.empty()) return 0;
  double sum = 0;
  for (double value : samples) sum += value * value;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

}  // namespace phs::rail
