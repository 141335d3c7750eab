#include "analysis/en14363.h"

#include <algorithm>
#include <cmath>

#include "analysis/running_statistics.h"
#include "rail/running_safety.h"

namespace phs::analysis {
namespace {

constexpr double kForceCutoff_Hz = 20;
constexpr double kWindow_m = 2;
constexpr double kStep_m = 0.5;
constexpr double kLow = 0.15;
constexpr double kHigh = 99.85;
constexpr double kYOverQLimit = 0.8;
constexpr double kUnloadingLimit = 1;
constexpr double kLargestQ_N = 200e3;
constexpr double kQuasiStaticQ_N = 145e3;
constexpr double kQuasiStaticY_N = 60e3;
constexpr double kSmallRadius_m = 400;
constexpr double kInstabilityWindow_m = 100;
constexpr double kInstabilityStep_m = 10;
constexpr double kHalfBand_Hz = 2;

using Signal = std::vector<double>;

double LargerPercentile(const Signal& signal) {
  return std::max(std::abs(Percentile(signal, kLow)), std::abs(Percentile(signal, kHigh)));
}

Signal Sum(const Signal& a, const Signal& b) {
  Signal sum = a;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += b[i];
  return sum;
}

/// Mean over 2 m of the filtered signal.
Result<Signal> TwoMetre(const Signal& distance, const Signal& signal, double interval_s) {
  const auto filtered = LowPass(signal, interval_s, kForceCutoff_Hz);
  if (!filtered.ok()) return filtered.error();
  return SlidingMean(distance, filtered.value(), kWindow_m, kStep_m);
}

/// A wheel that has lifted off guides nothing.
Signal Quotient(const Signal& y, const Signal& q) {
  Signal quotient = y;
  for (std::size_t i = 0; i < y.size(); ++i) quotient[i] = q[i] > 0 ? y[i] / q[i] : 0.0;
  return quotient;
}

struct WheelValues {
  double y_over_q = 0;
  double q_largest = 0;
  double y_quasi_static = 0;
  double q_quasi_static = 0;
  double unloading = 0;
};

Result<WheelValues> AssessWheel(const Signal& distance, const Signal& y, const Signal& q,
                                const SectionConditions& c) {
  const auto y_mean = TwoMetre(distance, y, c.interval_s);
  const auto q_mean = TwoMetre(distance, q, c.interval_s);
  const auto y_low = LowPass(y, c.interval_s, kForceCutoff_Hz);
  const auto q_low = LowPass(q, c.interval_s, kForceCutoff_Hz);
  for (const auto* result : {&y_mean, &q_mean, &y_low, &q_low}) {
    if (!result->ok()) return result->error();
  }
  WheelValues v;
  v.y_over_q = LargerPercentile(Quotient(y_mean.value(), q_mean.value()));
  v.q_largest = Percentile(q_low.value(), kHigh);
  v.y_quasi_static = std::abs(Percentile(y_low.value(), 50));
  v.q_quasi_static = Percentile(q_low.value(), 50);
  v.unloading = 1 - Percentile(q_low.value(), kLow) / c.static_wheel_load_N;
  return v;
}

Status Validate(const WheelsetForces& f, const SectionConditions& c) {
  const std::size_t n = f.distance_m.size();
  for (const Signal* signal : {&f.y_left_N, &f.y_right_N, &f.q_left_N, &f.q_right_N}) {
    if (signal->size() != n) {
      return Error{"EN 14363", "signals differ in length", "one value per place", ""};
    }
  }
  if (n < 2 || f.distance_m.back() - f.distance_m.front() < kWindow_m) {
    return Error{"EN 14363", "the section is shorter than 2 m", "2 m and more", ""};
  }
  if (!(c.static_wheel_load_N > 0)) {
    return Error{"EN 14363", "the static wheel load is not positive", "> 0 N", ""};
  }
  if (c.hunting_Hz != 0 && !(c.hunting_Hz > kHalfBand_Hz)) {
    return Error{"EN 14363", "the hunting frequency is too low", "0 or > 2 Hz", ""};
  }
  return {};
}

/// Instability: largest sliding root mean square of the band around the hunting frequency.
Result<double> InstabilityRms(const WheelsetForces& f, const SectionConditions& c) {
  const auto band = BandPass(Sum(f.y_left_N, f.y_right_N), c.interval_s,
                             c.hunting_Hz - kHalfBand_Hz, c.hunting_Hz + kHalfBand_Hz);
  if (!band.ok()) return band.error();
  // On a short section, one window over all of it.
  const double length = f.distance_m.back() - f.distance_m.front();
  const auto rms = SlidingRms(f.distance_m, band.value(), std::min(length, kInstabilityWindow_m),
                              kInstabilityStep_m);
  if (!rms.ok()) return rms.error();
  return *std::max_element(rms.value().begin(), rms.value().end());
}

}  // namespace

Result<std::vector<AssessedQuantity>> AssessWheelset(const WheelsetForces& f,
                                                     const SectionConditions& c) {
  if (Status s = Validate(f, c); !s.ok()) return s.error();
  const auto sum_y = TwoMetre(f.distance_m, Sum(f.y_left_N, f.y_right_N), c.interval_s);
  if (!sum_y.ok()) return sum_y.error();
  const auto left = AssessWheel(f.distance_m, f.y_left_N, f.q_left_N, c);
  if (!left.ok()) return left.error();
  const auto right = AssessWheel(f.distance_m, f.y_right_N, f.q_right_N, c);
  if (!right.ok()) return right.error();
  const auto worse = [&](double WheelValues::*part) {
    return std::max(left.value().*part, right.value().*part);
  };
  const double shift = rail::CalcTrackShiftLimit(c.static_wheel_load_N, c.prudhomme_factor);
  const bool small = c.radius_m > 0 && c.radius_m < kSmallRadius_m;
  std::vector<AssessedQuantity> rows = {
      {"sum_Y_N", LargerPercentile(sum_y.value()), shift},
      {"Y_over_Q", worse(&WheelValues::y_over_q), kYOverQLimit},
      {"Q_N", worse(&WheelValues::q_largest), std::min(90e3 + c.static_wheel_load_N, kLargestQ_N)},
      {"Y_qst_N", worse(&WheelValues::y_quasi_static),
       small ? 30e3 + 10500e3 / c.radius_m : kQuasiStaticY_N},
      {"Q_qst_N", worse(&WheelValues::q_quasi_static), kQuasiStaticQ_N},
      {"unloading", worse(&WheelValues::unloading), kUnloadingLimit},
  };
  if (c.hunting_Hz > 0) {
    const auto rms = InstabilityRms(f, c);
    if (!rms.ok()) return rms.error();
    rows.push_back({"sum_Y_rms_N", rms.value(), 0.5 * shift});
  }
  return rows;
}

Result<AccelerationStatistics> AssessAcceleration(const Signal& acceleration, double interval_s) {
  constexpr double kLow_Hz = 0.4;
  constexpr double kHigh_Hz = 10;
  const auto band = BandPass(acceleration, interval_s, kLow_Hz, kHigh_Hz);
  if (!band.ok()) return band.error();
  AccelerationStatistics out;
  out.low = Percentile(band.value(), kLow);
  out.high = Percentile(band.value(), kHigh);
  double squares = 0;
  for (const double a : band.value()) squares += a * a;
  if (!acceleration.empty()) {
    out.rms = std::sqrt(squares / static_cast<double>(acceleration.size()));
  }
  return out;
}

}  // namespace phs::analysis
