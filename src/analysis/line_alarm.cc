#include "analysis/line_alarm.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <random>

namespace phs::analysis {
namespace {

constexpr double kEuler = 0.57721566490153286;
constexpr double kVacuum = 1e3;   ///< a logarithm does not go on to a perfect vacuum [Pa]
constexpr double kProduct = 1e6;  ///< p_1 of the product [Pa]

double LogProduct(double a, double b, double of) {
  return std::log(std::max(a, kVacuum) / of * (std::max(b, kVacuum) / of));
}

constexpr PairForm kForms[] = {
    {"difference", "Pa", false, [](double a, double b, double) { return a - b; }},
    {"sum", "Pa", false, [](double a, double b, double) { return a + b; }},
    {"ratio", "-", false,
     [](double a, double b, double) {
       return std::log(std::max(a, kVacuum) / std::max(b, kVacuum));
     }},
    {"product", "-", false, [](double a, double b, double) { return LogProduct(a, b, kProduct); }},
    {"product over rest", "-", true, LogProduct},
};

constexpr int kRedrawn = 400;
constexpr double kConfidence = 0.95;

/// Geometric mean of the lines beside a pair [Pa].
double RestOf(const PairSignal& signal, const std::vector<std::vector<double>>& pressures,
              size_t row) {
  double sum = 0;
  for (size_t l = 0; l < pressures.size(); ++l) {
    if (static_cast<int>(l) == signal.first || static_cast<int>(l) == signal.second) continue;
    sum += std::log(std::max(pressures[l][row], kVacuum));
  }
  return std::exp(sum / static_cast<double>(pressures.size() - 2));
}

/// Gumbel's reduced variate of a block that is exceeded with probability r.
double Reduced(double r) { return -std::log(-std::log1p(-r)); }

}  // namespace

std::span<const PairForm> PairForms() { return kForms; }

std::vector<PairSignal> PairSignals(int lines) {
  std::vector<PairSignal> all;
  for (int i = 0; i < lines; ++i) {
    for (int j = i + 1; j < lines; ++j) {
      for (const PairForm& form : kForms) {
        if (form.needs_rest && lines < 3) continue;
        for (const bool against_mean : {false, true}) {
          for (const bool above : {true, false}) all.push_back({i, j, &form, against_mean, above});
        }
      }
    }
  }
  return all;
}

std::vector<double> CalcSignal(const PairSignal& signal,
                               const std::vector<std::vector<double>>& pressures, double interval_s,
                               const SignalTimes& times) {
  const std::vector<double>& a = pressures[static_cast<size_t>(signal.first)];
  const std::vector<double>& b = pressures[static_cast<size_t>(signal.second)];
  const double share = times.lag_s > 0 ? -std::expm1(-interval_s / times.lag_s) : 1;
  const double mean_share = -std::expm1(-interval_s / times.mean_s);
  std::vector<double> out(a.size());
  double y = 0, mean = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double rest = signal.form->needs_rest ? RestOf(signal, pressures, i) : 0;
    const double x = signal.sign() * signal.form->value(a[i], b[i], rest);
    y = i == 0 ? x : y + share * (x - y);
    mean += std::max(mean_share, 1 / static_cast<double>(i + 1)) * (y - mean);
    out[i] = signal.against_mean ? y - mean : y;
  }
  return out;
}

std::vector<double> BlockMaxima(const std::vector<double>& place, const std::vector<double>& signal,
                                double block_m) {
  std::vector<double> maxima;
  if (place.empty()) return maxima;
  double end = place.front() + block_m, largest = -HUGE_VAL;
  for (size_t i = 0; i < place.size(); ++i) {
    while (place[i] >= end) {
      if (std::isfinite(largest)) maxima.push_back(largest);
      largest = -HUGE_VAL;
      end += block_m;
    }
    largest = std::max(largest, signal[i]);
  }
  return maxima;
}

double Extremes::Level(double r) const {
  const double y = Reduced(r);
  return location + scale * (shape == 0 ? y : -std::expm1(-shape * y) / shape);
}

double Extremes::UpperLevel(double r) const {
  std::mt19937_64 draw(1);
  std::vector<double> levels;
  std::vector<double> sample(static_cast<size_t>(count));
  for (int k = 0; k < kRedrawn; ++k) {
    for (double& x : sample) {
      // 53 random bits: the same number on every machine.
      const double u = (static_cast<double>(draw() >> 11) + 0.5) / 9007199254740992.0;
      x = Level(1 - u);
    }
    levels.push_back(FitExtremes(sample).Level(r));
  }
  std::sort(levels.begin(), levels.end());
  return std::max(Level(r), levels[static_cast<size_t>(kConfidence * kRedrawn)]);
}

Extremes FitExtremes(std::vector<double> maxima) {
  std::sort(maxima.begin(), maxima.end());
  const double n = static_cast<double>(maxima.size());
  double b0 = 0, b1 = 0, b2 = 0;  // probability-weighted moments
  for (size_t i = 0; i < maxima.size(); ++i) {
    const double j = static_cast<double>(i);
    b0 += maxima[i] / n;
    b1 += maxima[i] * j / (n * (n - 1));
    b2 += maxima[i] * j * (j - 1) / (n * (n - 1) * (n - 2));
  }
  const double l2 = 2 * b1 - b0, skewness = l2 > 0 ? (6 * b2 - 6 * b1 + b0) / l2 : 0;
  const double c = 2 / (3 + skewness) - std::log(2.0) / std::log(3.0);
  const double k = std::min(0.0, 7.8590 * c + 2.9554 * c * c);
  const int count = static_cast<int>(maxima.size());
  if (k > -1e-6) {
    const double scale = l2 / std::log(2.0);
    return {b0 - kEuler * scale, scale, 0, count};
  }
  const double gamma = std::tgamma(1 + k);
  const double scale = l2 * k / ((1 - std::pow(2.0, -k)) * gamma);
  return {b0 - scale * (1 - gamma) / k, scale, k, count};
}

int CountAlarms(const std::vector<double>& signal, double threshold, double interval_s,
                double hold_s) {
  int count = 0;
  double since = HUGE_VAL;  // the last row above
  for (const double x : signal) {
    if (x > threshold) {
      if (since > hold_s) ++count;
      since = 0;
    } else {
      since += interval_s;
    }
  }
  return count;
}

double PoissonUpper(int count, double confidence) {
  return boost::math::gamma_q_inv(count + 1.0, 1 - confidence);
}

}  // namespace phs::analysis
