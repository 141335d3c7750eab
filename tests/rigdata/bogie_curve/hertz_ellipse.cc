#include "hertz_ellipse.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bogie_curve {
namespace {

constexpr double kLargestLog = 9.0;  // ratios of curvature up to e^9

// K and E of modulus e, e^2 = 1 - g^2, by the arithmetic-geometric mean.
std::pair<double, double> EllipticIntegrals(double g) {
  double a = 1, b = g, power = 0.5;
  double sum = power * (1 - g * g);
  while (std::abs(a - b) > 1e-15 * a) {
    const double c = 0.5 * (a - b);
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
    power *= 2;
    sum += power * c * c;
  }
  const double K = std::numbers::pi / (2 * a);
  return {K, K * (1 - sum)};
}

double CurvatureRatio(double g) {
  if (g > 1 - 1e-9) return 1;
  const auto [K, E] = EllipticIntegrals(g);
  return (E / (g * g) - K) / (K - E);
}

}  // namespace

HertzEllipse::HertzEllipse(const Material& material)
    : modulus_(material.shear_modulus / (1 - material.poisson)) {
  for (int i = 0; i < kRows; ++i) {
    const double ratio = std::exp(kLargestLog * i / (kRows - 1));
    double low = 1e-4, high = 1;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (CurvatureRatio(middle) > ratio ? low : high) = middle;
    }
    const auto [K, E] = EllipticIntegrals(high);
    row_[static_cast<size_t>(i)] = {high, K, E};
  }
}

Ellipse HertzEllipse::At(double A, double B, double depth) const {
  const double most = std::max(A, B), least = std::min(A, B);
  const double place = std::clamp(std::log(most / least) / kLargestLog, 0.0, 1.0) * (kRows - 1);
  const auto i = static_cast<size_t>(std::min(place, kRows - 2.0));
  const double w = place - static_cast<double>(i);
  const auto mix = [&](double Row::*m) { return (1 - w) * row_[i].*m + w * row_[i + 1].*m; };
  const double g = mix(&Row::g), K = mix(&Row::K), E = mix(&Row::E);
  const double minor = std::sqrt(depth * E / ((A + B) * K));
  Ellipse ellipse;
  ellipse.a = A > B ? minor : minor / g;
  ellipse.b = A > B ? minor / g : minor;
  ellipse.normal = 2 * std::numbers::pi / 3 * modulus_ * (A + B) * minor * minor * minor / (g * E);
  ellipse.pressure = 1.5 * ellipse.normal / (std::numbers::pi * ellipse.a * ellipse.b);
  return ellipse;
}

}  // namespace bogie_curve
