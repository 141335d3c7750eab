#include "rail/kalker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace phs::rail {
namespace {

constexpr int kRows = 19;
/// [row by a/b][Poisson ratio 0, 0.25, 0.5][C11, C22, C23, C33]
constexpr double kTable[kRows][3][4] = {
    {{2.51, 2.51, 0.334, 6.42}, {3.31, 2.52, 0.473, 8.28}, {4.85, 2.53, 0.731, 11.7}},  // a/b = 0.1
    {{2.59, 2.59, 0.483, 3.46}, {3.37, 2.63, 0.603, 4.27}, {4.81, 2.66, 0.809, 5.66}},  // a/b = 0.2
    {{2.68, 2.68, 0.607, 2.49}, {3.44, 2.75, 0.715, 2.96}, {4.8, 2.81, 0.889, 3.72}},   // a/b = 0.3
    {{2.78, 2.78, 0.72, 2.02}, {3.53, 2.88, 0.823, 2.32}, {4.82, 2.98, 0.977, 2.77}},   // a/b = 0.4
    {{2.88, 2.88, 0.827, 1.74}, {3.62, 3.01, 0.929, 1.93}, {4.83, 3.14, 1.07, 2.22}},   // a/b = 0.5
    {{2.98, 2.98, 0.93, 1.56}, {3.72, 3.14, 1.03, 1.68}, {4.91, 3.31, 1.18, 1.86}},     // a/b = 0.6
    {{3.09, 3.09, 1.03, 1.43}, {3.81, 3.28, 1.14, 1.5}, {4.97, 3.48, 1.29, 1.6}},       // a/b = 0.7
    {{3.19, 3.19, 1.13, 1.34}, {3.91, 3.41, 1.25, 1.37}, {5.05, 3.65, 1.4, 1.42}},      // a/b = 0.8
    {{3.29, 3.29, 1.23, 1.27}, {4.01, 3.54, 1.36, 1.27}, {5.12, 3.82, 1.51, 1.27}},     // a/b = 0.9
    {{3.4, 3.4, 1.33, 1.21}, {4.12, 3.67, 1.47, 1.19}, {5.2, 3.98, 1.63, 1.16}},        // a/b = 1
    {{3.51, 3.51, 1.44, 1.16}, {4.22, 3.81, 1.59, 1.11}, {5.3, 4.16, 1.77, 1.06}},   // a/b = 1.111
    {{3.65, 3.65, 1.58, 1.1}, {4.36, 3.99, 1.75, 1.04}, {5.42, 4.39, 1.94, 0.954}},  // a/b = 1.25
    {{3.82, 3.82, 1.76, 1.05},
     {4.54, 4.21, 1.95, 0.965},
     {5.58, 4.67, 2.18, 0.852}},                                                     // a/b = 1.429
    {{4.06, 4.06, 2.01, 1.01}, {4.78, 4.5, 2.23, 0.892}, {5.8, 5.04, 2.5, 0.751}},   // a/b = 1.667
    {{4.37, 4.37, 2.35, 0.958}, {5.1, 4.9, 2.62, 0.819}, {6.11, 5.56, 2.96, 0.65}},  // a/b = 2
    {{4.84, 4.84, 2.88, 0.912}, {5.57, 5.48, 3.24, 0.747}, {6.57, 6.31, 3.7, 0.549}},  // a/b = 2.5
    {{5.57, 5.57, 3.79, 0.868},
     {6.34, 6.4, 4.32, 0.674},
     {7.34, 7.51, 5.01, 0.446}},  // a/b = 3.333
    {{6.96, 6.96, 5.72, 0.828}, {7.78, 8.14, 6.63, 0.601}, {8.82, 9.79, 7.89, 0.341}},  // a/b = 5
    {{10.7, 10.7, 12.2, 0.795}, {11.7, 12.8, 14.6, 0.526}, {12.9, 16.0, 18.0, 0.228}},  // a/b = 10
};
/// g = min(a/b, b/a) of the rows: 0.1 … 1 … 0.1.
constexpr double kSmallestRatio = 0.1;

using Four = std::array<double, 4>;

/// 1/C is a parabola through the three tabulated Poisson ratios.
Four AtPoisson(int row, double nu) {
  const double w0 = (nu - 0.25) * (nu - 0.5) / 0.125;
  const double w1 = -nu * (nu - 0.5) / 0.0625;
  const double w2 = nu * (nu - 0.25) / 0.125;
  Four c;
  for (int i = 0; i < 4; ++i) {
    c[i] = 1 / (w0 / kTable[row][0][i] + w1 / kTable[row][1][i] + w2 / kTable[row][2][i]);
  }
  return c;
}

/// Asymptotes of C11, C22, C23 for slender ellipses (Kalker 1990); C33 follows g^-1 (a < b) and
/// g^1/2.
Four Asymptote(double g, bool short_along, double nu) {
  const double pi = std::numbers::pi;
  if (short_along) {  // a < b
    return {pi * pi / (4 * (1 - nu)), pi * pi / 4,
            pi * std::sqrt(g) / (3 * (1 - nu)) * (1 + nu * (std::log(16 / g) - 5)), 1 / g};
  }
  const double l = std::log(16 / (g * g));
  const double k = 3 - std::log(4.0);
  const double d = (1 - nu) * l + 2 * nu;
  return {2 * pi / ((l - 2 * nu) * g) * (1 + k / (l - 2 * nu)),
          2 * pi / g * (1 + (1 - nu) * k / d) / d,
          2 * pi / (3 * std::pow(g, 1.5) * ((1 - nu) * l - 2 + 4 * nu)), 1};
}

}  // namespace

KalkerCoefficients CalcKalkerCoefficients(double a_over_b, double nu) {
  const bool short_along = a_over_b <= 1;
  const double g = short_along ? a_over_b : 1 / a_over_b;
  const double place =
      (std::max(g, kSmallestRatio) - kSmallestRatio) / 0.1;  // rows from the end to a = b
  const int below = std::min(static_cast<int>(place), 8);
  const double part = place - below;
  const int row0 = short_along ? below : kRows - 1 - below;
  const int row1 = short_along ? below + 1 : kRows - 2 - below;
  const Four c0 = AtPoisson(row0, nu);
  const Four c1 = AtPoisson(row1, nu);
  Four c;
  for (int i = 0; i < 4; ++i) c[i] = c0[i] + part * (c1[i] - c0[i]);
  if (g < kSmallestRatio) {
    const Four here = Asymptote(g, short_along, nu);
    const Four edge = Asymptote(kSmallestRatio, short_along, nu);
    for (int i = 0; i < 4; ++i) c[i] *= here[i] / edge[i];
  }
  return {c[0], c[1], c[2], c[3]};
}

namespace {
/// Ends of the curve in a/(a + b); C11 grows without limit towards 1.
constexpr double kLowest = 1.0 / 151;
}  // namespace

KalkerCurve::KalkerCurve(double poisson_ratio) {
  for (int i = 0; i <= kIntervals; ++i) {
    const double chi = kLowest + (1 - 2 * kLowest) * i / kIntervals;
    knot_[i] = CalcKalkerCoefficients(chi / (1 - chi), poisson_ratio);
  }
}

KalkerCoefficients KalkerCurve::At(double a_over_b) const noexcept {
  return AtShare(std::isfinite(a_over_b) ? a_over_b / (1 + a_over_b) : 1);
}

KalkerCoefficients KalkerCurve::AtShare(double chi) const noexcept {
  const double place =
      std::clamp((chi - kLowest) / (1 - 2 * kLowest), 0.0, 1.0) * static_cast<double>(kIntervals);
  const int i = std::min(static_cast<int>(place), kIntervals - 1);
  const double t = place - i;
  const KalkerCoefficients& p = knot_[i];
  const KalkerCoefficients& q = knot_[i + 1];
  return {p.c11 + t * (q.c11 - p.c11), p.c22 + t * (q.c22 - p.c22), p.c23 + t * (q.c23 - p.c23),
          p.c33 + t * (q.c33 - p.c33)};
}

CreepForce CalcLinearCreep(const CreepInput& in, const KalkerCoefficients& c,
                           double shear) noexcept {
  const double ab = in.a * in.b;
  const double ab15 = ab * std::sqrt(ab);
  return {-shear * ab * c.c11 * in.xi, -shear * (ab * c.c22 * in.eta + ab15 * c.c23 * in.phi),
          shear * (ab15 * c.c23 * in.eta - ab * ab * c.c33 * in.phi)};
}

}  // namespace phs::rail
