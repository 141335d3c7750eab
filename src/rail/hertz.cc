#include "rail/hertz.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace phs::rail {
namespace {

constexpr int kIntervals = 1024;
constexpr double kMaxLogRatio = 12;  ///< ratio of curvatures up to e^12

/// Complete elliptic integrals of modulus e = sqrt(1 - g^2), 0 < g <= 1, by the
/// arithmetic-geometric mean: a, b, c -> (a + b)/2, sqrt(a b), (a - b)/2 from 1, g, e; S = sum
/// 2^(n-1) c_n^2; K = pi/(2 a), E = K (1 - S) (Abramowitz and Stegun, 17.6.3 and 17.6.4).
struct EllipticIntegrals {
  double k = 0;           ///< K
  double difference = 0;  ///< S = (K - E)/K, without the loss of digits of K - E
};

EllipticIntegrals CalcElliptic(double g) {
  double a = 1, b = g, weight = 0.5;
  double sum = weight * (1 - g) * (1 + g);
  while (a - b > 1e-9 * a) {  // the next term is of the square of this
    const double c = (a - b) / 2;
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
    weight *= 2;
    sum += weight * c * c;
  }
  return {std::numbers::pi / (a + b), sum};
}

/// (larger / smaller curvature) of an ellipse of axis ratio g < 1: (E/g^2 - K)/(K - E).
double CurvatureRatio(double g) {
  const double s = CalcElliptic(g).difference;
  return ((1 - g) * (1 + g) - s) / (g * g * s);
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
    const EllipticIntegrals at = CalcElliptic(g);
    table_.push_back({g, 1 - at.difference, at.k * (1 - at.difference)});
  }
}

double Hertz::Stiffness(double along, double across) const noexcept {
  return AtApproach(1, along, across).normal;
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
  return normal > 0 ? std::pow(normal / Stiffness(along, across), 2.0 / 3.0) : 0.0;
}

}  // namespace phs::rail
