#include "rail/en14363.h"

#include <algorithm>
#include <cmath>

#include "rail/running_safety.h"
#include "rail/signal_filter.h"

namespace phs::rail {
namespace {

constexpr double kCutOff = 20;  // [Hz]
constexpr double kWindow = 2;   // [m]
constexpr double kStep = 0.5;   // [m]
constexpr double kLowPercent = 0.15;
constexpr double kHighPercent = 99.85;
constexpr double kRmsWindow = 100;  // [m]
constexpr double kRmsStep = 10;     // [m]
constexpr double kHalfBand = 2;     // [Hz]

Status Check(const WheelsetRecord& r) {
  const std::size_t n = r.distance.size();
  if (n < 2) return Error{"section", "has fewer than two samples", "a recorded section", ""};
  for (const auto* channel : {&r.y_left, &r.y_right, &r.q_left, &r.q_right}) {
    if (channel->size() != n) {
      return Error{"section", "channels differ in length", "as many samples as the distance", ""};
    }
  }
  if (!(r.static_wheel_load > 0)) {
    return Error{"static_wheel_load", "is not positive", "Q0 above 0 N", ""};
  }
  if (r.distance.back() - r.distance.front() < kWindow) {
    return Error{"section", "is shorter than 2 m", "a longer section", ""};
  }
  return {};
}

struct FilteredWheel {
  std::vector<double> y, q;
};

Result<FilteredWheel> Filter(const std::vector<double>& y, const std::vector<double>& q,
                             double sample_rate) {
  auto fy = LowPass(y, sample_rate, kCutOff);
  if (!fy.ok()) return fy.error();
  auto fq = LowPass(q, sample_rate, kCutOff);
  if (!fq.ok()) return fq.error();
  return FilteredWheel{std::move(fy).value(), std::move(fq).value()};
}

Result<WheelStatistics> StatisticsOf(const FilteredWheel& wheel, const WheelsetRecord& r) {
  const auto y2 = SlidingMean(r.distance, wheel.y, kWindow, kStep);
  if (!y2.ok()) return y2.error();
  const auto q2 = SlidingMean(r.distance, wheel.q, kWindow, kStep);
  if (!q2.ok()) return q2.error();
  std::vector<double> ratio;
  for (std::size_t i = 0; i < y2.value().size(); ++i) {
    // A wheel that has left the rail carries no guiding force either.
    const double q = q2.value()[i];
    ratio.push_back(q > 0 ? y2.value()[i] / q : 0.0);
  }
  WheelStatistics s;
  s.y_over_q_2m = PercentileSize(ratio, kHighPercent);
  s.q_max = Percentile(wheel.q, kHighPercent);
  s.y_qst = Percentile(wheel.y, 50);
  s.q_qst = Percentile(wheel.q, 50);
  s.unloading = 1 - Percentile(wheel.q, kLowPercent) / r.static_wheel_load;
  return s;
}

/// Largest rms of the sum of guiding forces around the frequency of hunting.
Result<double> Instability(const WheelsetRecord& r, const std::vector<double>& sum) {
  if (!(r.instability_frequency > 0)) return 0.0;
  const double low = std::max(0.1, r.instability_frequency - kHalfBand);
  const auto band = BandPass(sum, r.sample_rate, low, r.instability_frequency + kHalfBand);
  if (!band.ok()) return band.error();
  const double length = r.distance.back() - r.distance.front();
  const auto rms = SlidingRms(r.distance, band.value(), std::min(kRmsWindow, length), kRmsStep);
  if (!rms.ok()) return rms.error();
  return *std::max_element(rms.value().begin(), rms.value().end());
}

}  // namespace

Result<WheelsetStatistics> CalcWheelsetStatistics(const WheelsetRecord& r) {
  const Status good = Check(r);
  if (!good.ok()) return good.error();
  const auto left = Filter(r.y_left, r.q_left, r.sample_rate);
  if (!left.ok()) return left.error();
  const auto right = Filter(r.y_right, r.q_right, r.sample_rate);
  if (!right.ok()) return right.error();
  std::vector<double> sum(r.distance.size());
  std::vector<double> raw(r.distance.size());
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] = left.value().y[i] + right.value().y[i];
    raw[i] = r.y_left[i] + r.y_right[i];
  }
  const auto sum_2m = SlidingMean(r.distance, sum, kWindow, kStep);
  if (!sum_2m.ok()) return sum_2m.error();
  WheelsetStatistics s;
  s.sum_y_2m = PercentileSize(sum_2m.value(), kHighPercent);
  const auto unstable = Instability(r, raw);
  if (!unstable.ok()) return unstable.error();
  s.sum_y_rms_max = unstable.value();
  const auto l = StatisticsOf(left.value(), r);
  if (!l.ok()) return l.error();
  const auto q = StatisticsOf(right.value(), r);
  if (!q.ok()) return q.error();
  s.left = l.value();
  s.right = q.value();
  s.length = r.distance.back() - r.distance.front();
  return s;
}

Result<AccelerationStatistics> CalcAccelerationStatistics(const std::vector<double>& acceleration,
                                                          double sample_rate) {
  const auto band = BandPass(acceleration, sample_rate, 0.4, 10);
  if (!band.ok()) return band.error();
  return AccelerationStatistics{PercentileSize(band.value(), kHighPercent), Rms(band.value())};
}

RunningLimits CalcRunningLimits(double static_wheel_load, double curve_radius, double k1) {
  RunningLimits limits;
  limits.sum_y_2m = CalcTrackShiftLimit(static_wheel_load, k1);
  limits.sum_y_rms = 0.5 * limits.sum_y_2m;
  const double radius = std::abs(curve_radius);
  if (radius > 0 && radius < 400) limits.y_qst = 30e3 + 10500e3 / radius;
  limits.q_max = std::min(90e3 + static_wheel_load, 200e3);
  return limits;
}

std::string CurveClassOf(double curve_radius) {
  const double radius = std::abs(curve_radius);
  if (radius == 0) return "straight";
  if (radius > 600) return "large";
  if (radius >= 400) return "small";
  if (radius >= 250) return "very small";
  return "below 250 m";
}

}  // namespace phs::rail
