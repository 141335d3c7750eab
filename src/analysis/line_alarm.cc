#include "analysis/line_alarm.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

namespace phs::analysis {
namespace {

constexpr double kEuler = 0.57721566490153286;
constexpr double kVacuum = 1e3;  ///< a ratio does not go on to a perfect vacuum [Pa]

constexpr PairForm kForms[] = {
    {"difference", "Pa", [](double a, double b) { return a - b; }},
    {"sum", "Pa", [](double a, double b) { return a + b; }},
    {"ratio", "-",
     [](double a, double b) { return std::log(std::max(a, kVacuum) / std::max(b, kVacuum)); }},
};

/// Gumbel's reduced variate of a block that is exceeded with probability r.
double Reduced(double r) { return -std::log(-std::log1p(-r)); }

}  // namespace

std::span<const PairForm> PairForms() { return kForms; }

std::vector<PairSignal> PairSignals(int lines) {
  std::vector<PairSignal> all;
  for (int i = 0; i < lines; ++i) {
    for (int j = i + 1; j < lines; ++j) {
      for (const PairForm& form : kForms) {
        for (const bool above : {true, false}) all.push_back({i, j, &form, above});
      }
    }
  }
  return all;
}

std::vector<double> CalcSignal(const PairSignal& signal,
                               const std::vector<std::vector<double>>& pressures, double interval_s,
                               double lag_s) {
  const std::vector<double>& a = pressures[static_cast<size_t>(signal.first)];
  const std::vector<double>& b = pressures[static_cast<size_t>(signal.second)];
  const double share = lag_s > 0 ? -std::expm1(-interval_s / lag_s) : 1;
  std::vector<double> out(a.size());
  double y = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double x = signal.sign() * signal.form->value(a[i], b[i]);
    y = i == 0 ? x : y + share * (x - y);
    out[i] = y;
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

double Gumbel::Level(double r) const { return location + scale * Reduced(r); }

double Gumbel::LevelError(double r) const {
  const double y = Reduced(r);
  return scale * std::sqrt((1.1128 + 0.4574 * y + 0.8046 * y * y) / count);
}

Gumbel FitGumbel(std::vector<double> maxima) {
  std::sort(maxima.begin(), maxima.end());
  const double n = static_cast<double>(maxima.size());
  double b0 = 0, b1 = 0;  // probability-weighted moments
  for (size_t i = 0; i < maxima.size(); ++i) {
    b0 += maxima[i] / n;
    b1 += maxima[i] * static_cast<double>(i) / (n * (n - 1));
  }
  const double scale = (2 * b1 - b0) / std::log(2.0);
  return {b0 - kEuler * scale, scale, static_cast<int>(maxima.size())};
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
