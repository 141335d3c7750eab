#include "motion_estimate.h"

#include <algorithm>
#include <cmath>

namespace rigdata {
namespace {

constexpr int kHalfWidths[] = {2, 3, 5, 8, 12, 18, 27, 40, 60, 90};

struct LocalFit {
  double x = 0, v = 0, x_deviation = 0, v_deviation = 0;
};

// Least squares of a + b j + c j² over j = −n … n; a and b per sample interval.
LocalFit FitQuadratic(const std::vector<double>& y, long centre, int n) {
  double sum = 0, first = 0, second = 0;
  for (int j = -n; j <= n; ++j) {
    const double value = y[centre + j] - y[centre];
    sum += value;
    first += j * value;
    second += static_cast<double>(j) * j * value;
  }
  const double count = 2 * n + 1, m = n;
  const double s2 = m * (m + 1) * count / 3.0;
  const double s4 = s2 * (3 * m * m + 3 * m - 1) / 5.0;
  const double determinant = count * s4 - s2 * s2;
  LocalFit fit;
  fit.x = y[centre] + (s4 * sum - s2 * second) / determinant;
  fit.v = first / s2;
  fit.x_deviation = std::sqrt(s4 / determinant);
  fit.v_deviation = 1.0 / std::sqrt(s2);
  return fit;
}

// Narrows [low, high] by one more interval; false when nothing is left.
bool Intersect(double value, double deviation, double* low, double* high) {
  *low = std::max(*low, value - deviation);
  *high = std::min(*high, value + deviation);
  return *low <= *high;
}

}  // namespace

MotionEstimate EstimateMotion(const std::vector<double>& samples, double rate, double noise,
                              double confidence) {
  MotionEstimate estimate;
  estimate.rate = rate;
  const long count = static_cast<long>(samples.size());
  estimate.x = samples;
  estimate.v.assign(samples.size(), 0.0);
  const double width = confidence * noise;
  for (long i = 2; i + 2 < count; ++i) {
    double x_low = -1e9, x_high = 1e9, v_low = -1e9, v_high = 1e9;
    bool x_open = true, v_open = true;
    for (const int n : kHalfWidths) {
      if (i - n < 0 || i + n >= count) break;
      const LocalFit fit = FitQuadratic(samples, i, n);
      x_open = x_open && Intersect(fit.x, width * fit.x_deviation, &x_low, &x_high);
      v_open = v_open && Intersect(fit.v, width * fit.v_deviation, &v_low, &v_high);
      if (x_open) estimate.x[i] = fit.x;
      if (v_open) estimate.v[i] = fit.v * rate;
      if (!x_open && !v_open) break;
    }
  }
  return estimate;
}

void MotionEstimate::MakeConsistent(double time) {
  const double h = 1.0 / rate, gain = h / time;
  std::vector<double> forward = x, backward = x;
  for (size_t i = 1; i < x.size(); ++i) {
    const double moved = forward[i - 1] + 0.5 * h * (v[i - 1] + v[i]);
    forward[i] = moved + gain * (x[i] - moved);
  }
  for (size_t i = x.size() - 1; i > 0; --i) {
    const double moved = backward[i] - 0.5 * h * (v[i - 1] + v[i]);
    backward[i - 1] = moved + gain * (x[i - 1] - moved);
  }
  for (size_t i = 0; i < x.size(); ++i) x[i] = 0.5 * (forward[i] + backward[i]);
}

ActuatorInput MotionEstimate::Input() const {
  const auto locate = [this](double t, size_t* k) {
    const double at = std::clamp(t * rate, 0.0, static_cast<double>(x.size() - 1));
    *k = std::min(static_cast<size_t>(at), x.size() - 2);
    return at - static_cast<double>(*k);
  };
  ActuatorInput input;
  input.position = [this, locate](double t) {
    size_t k = 0;
    const double u = locate(t, &k), h = 1.0 / rate;
    const double u2 = u * u, u3 = u2 * u;
    return x[k] * (2 * u3 - 3 * u2 + 1) + x[k + 1] * (3 * u2 - 2 * u3) +
           h * (v[k] * (u3 - 2 * u2 + u) + v[k + 1] * (u3 - u2));
  };
  input.speed = [this, locate](double t) {
    size_t k = 0;
    const double u = locate(t, &k);
    return v[k] + u * (v[k + 1] - v[k]);
  };
  return input;
}

}  // namespace rigdata
