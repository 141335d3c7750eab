#include "rail/hertz.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace phs::rail {
namespace {

constexpr int kIntervals = 1024;
constexpr double kMaxLogRatio = 12;  ///< ratio of curvatures up to e^12

/// (larger / smaller curvature) of an ellipse of axis ratio g < 1.
double CurvatureRatio(double g) {
  const double e = std::sqrt(1 - g * g);
  const double k = std::comp_ellint_1(e);
  const double l = std::comp_ellint_2(e);
  return (l / (g * g) - k) / (k - l);
}

/// Axis ratio for a ratio of curvatures >= 1, by bisection in log g.
double AxisRatio(double curvature_ratio) {
  double low = -20;
  double high = -1e-7;
  for (int i = 0; i < 80; ++i) {
    const double middle = (low + high) / 2;
    (CurvatureRatio(std::exp(middle)) > curvature_ratio ? low : high) = middle;
  }
  return std::exp((low + high) / 2);
}

}  // namespace

Hertz::Hertz(double shear_modulus_Pa, double poisson_ratio)
    : modulus_(shear_modulus_Pa / (1 - poisson_ratio)) {
  for (int i = 0; i <= kIntervals; ++i) {
    const double g = i == 0 ? 1.0 : AxisRatio(std::exp(kMaxLogRatio * i / kIntervals));
    const double e = std::sqrt(std::max(0.0, 1 - g * g));
    table_.push_back({g, std::comp_ellint_2(e) / std::comp_ellint_1(e), std::comp_ellint_2(e)});
  }
}

double Hertz::BedModulus(double along, double across) const noexcept {
  return 0.75 * std::sqrt(across) * AtApproach(1, along, across).normal;
}

Hertz::Shape Hertz::ShapeAt(double log_ratio) const noexcept {
  const double place = std::min(std::abs(log_ratio) / kMaxLogRatio, 1.0) * kIntervals;
  const int i = std::min(static_cast<int>(place), kIntervals - 1);
  const double t = place - i;
  const Shape& p = table_[static_cast<size_t>(i)];
  const Shape& q = table_[static_cast<size_t>(i) + 1];
  return {p.g + t * (q.g - p.g), p.e_over_k + t * (q.e_over_k - p.e_over_k), p.e + t * (q.e - p.e)};
}

HertzContact Hertz::AtApproach(double approach, double along, double across) const noexcept {
  if (!(approach > 0)) return {};
  const double pi = std::numbers::pi;
  const double log_ratio = std::log(across / along);
  const Shape s = ShapeAt(log_ratio);
  const double sum = along + across;
  const double minor = std::sqrt(approach * s.e_over_k / sum);
  const double major = minor / s.g;
  HertzContact c;
  // The ellipse is long where the curvature is small.
  c.a = log_ratio >= 0 ? major : minor;
  c.b = log_ratio >= 0 ? minor : major;
  c.normal = 2 * pi / 3 * modulus_ * sum * minor * minor * minor / (s.g * s.e);
  c.peak_pressure = 3 * c.normal / (2 * pi * c.a * c.b);
  c.approach = approach;
  return c;
}

HertzContact Hertz::UnderLoad(double normal, double along, double across) const noexcept {
  if (!(normal > 0)) return {};
  const double pi = std::numbers::pi;
  const double log_ratio = std::log(across / along);
  const Shape s = ShapeAt(log_ratio);
  const double minor = std::cbrt(1.5 / pi * normal * s.g * s.e / (modulus_ * (along + across)));
  const double major = minor / s.g;
  return {log_ratio >= 0 ? major : minor, log_ratio >= 0 ? minor : major, normal,
          1.5 * normal / (pi * minor * major), minor * minor * (along + across) / s.e_over_k};
}

double Hertz::ApproachUnder(double normal, double along, double across) const noexcept {
  const double unit = AtApproach(1e-4, along, across).normal;
  return normal > 0 ? 1e-4 * std::pow(normal / unit, 2.0 / 3.0) : 0.0;
}

}  // namespace phs::rail
