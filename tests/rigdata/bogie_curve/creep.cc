#include "creep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bogie_curve {
namespace {

using Four = std::array<double, 4>;  // C11, C22, C23, C33
struct TableRow {
  Four quarter, half;  // nu = 1/4, nu = 1/2
};

// a/b = 0.1, 0.2 … 1, then b/a = 0.9, 0.8 … 0.1.
constexpr TableRow kTable[19] = {
    {{3.31, 2.52, 0.473, 8.28}, {4.85, 2.53, 0.731, 11.7}},
    {{3.37, 2.63, 0.603, 4.27}, {4.81, 2.66, 0.809, 5.66}},
    {{3.44, 2.75, 0.715, 2.96}, {4.80, 2.81, 0.889, 3.72}},
    {{3.53, 2.88, 0.823, 2.32}, {4.82, 2.98, 0.977, 2.77}},
    {{3.62, 3.01, 0.929, 1.93}, {4.83, 3.14, 1.07, 2.22}},
    {{3.72, 3.14, 1.03, 1.68}, {4.91, 3.31, 1.18, 1.86}},
    {{3.81, 3.28, 1.14, 1.50}, {4.97, 3.48, 1.29, 1.60}},
    {{3.91, 3.41, 1.25, 1.37}, {5.05, 3.65, 1.40, 1.42}},
    {{4.01, 3.54, 1.36, 1.27}, {5.12, 3.82, 1.51, 1.27}},
    {{4.12, 3.67, 1.47, 1.19}, {5.20, 3.98, 1.63, 1.16}},
    {{4.22, 3.81, 1.59, 1.11}, {5.30, 4.16, 1.77, 1.06}},
    {{4.36, 3.99, 1.75, 1.04}, {5.42, 4.39, 1.94, 0.954}},
    {{4.54, 4.21, 1.95, 0.965}, {5.58, 4.67, 2.18, 0.852}},
    {{4.78, 4.50, 2.23, 0.892}, {5.80, 5.04, 2.50, 0.751}},
    {{5.10, 4.90, 2.62, 0.819}, {6.11, 5.56, 2.96, 0.650}},
    {{5.57, 5.48, 3.24, 0.747}, {6.57, 6.31, 3.70, 0.549}},
    {{6.34, 6.40, 4.32, 0.674}, {7.34, 7.51, 5.01, 0.446}},
    {{7.78, 8.14, 6.63, 0.601}, {8.82, 9.79, 7.89, 0.341}},
    {{11.7, 12.8, 14.6, 0.526}, {12.9, 16.0, 18.0, 0.228}},
};

}  // namespace

KalkerNumbers CalcKalkerNumbers(double a_over_b, double poisson) {
  const double g = std::max(0.1, std::min(a_over_b, 1 / a_over_b));
  const double place = a_over_b <= 1 ? 10 * g - 1 : 19 - 10 * g;
  const auto i = static_cast<size_t>(std::min(place, 17.0));
  const double along = place - static_cast<double>(i), across = (poisson - 0.25) / 0.25;
  Four c;
  for (size_t k = 0; k < 4; ++k) {
    const double quarter = (1 - along) * kTable[i].quarter[k] + along * kTable[i + 1].quarter[k];
    const double half = (1 - along) * kTable[i].half[k] + along * kTable[i + 1].half[k];
    c[k] = (1 - across) * quarter + across * half;
  }
  return {c[0], c[1], c[2], c[3]};
}

CreepWrench CalcLinearCreep(const Ellipse& ellipse, const Material& material,
                            const Creepage& creep) {
  const KalkerNumbers c = CalcKalkerNumbers(ellipse.Ratio(), material.poisson);
  const double area = ellipse.a * ellipse.b, stiff = material.shear_modulus * area;
  const double arm = std::sqrt(area);
  return {-stiff * c.c11 * creep.v1, -stiff * (c.c22 * creep.v2 + arm * c.c23 * creep.wn),
          stiff * arm * (c.c23 * creep.v2 - arm * c.c33 * creep.wn)};
}

CreepWrench CalcCreep(const Ellipse& ellipse, const Material& material, double friction,
                      const Creepage& creep) {
  constexpr int kStrips = 20, kCells = 20;
  const double a = ellipse.a, b = ellipse.b, G = material.shear_modulus;
  const KalkerNumbers c = CalcKalkerNumbers(ellipse.Ratio(), material.poisson);
  const double slope1 = creep.v1 * 3 * c.c11 * G / (8 * a);
  const double slope2 = creep.v2 * 3 * c.c22 * G / (8 * a);
  const double spin = creep.wn * 4 * c.c23 * G / (std::numbers::pi * a * std::sqrt(a / b));
  const double most = friction * 2 * ellipse.normal / (std::numbers::pi * a * b);
  CreepWrench wrench;
  for (int j = 0; j < kStrips; ++j) {
    const double y = b * ((2 * j + 1.0) / kStrips - 1), rest = 1 - y * y / (b * b);
    const double edge = a * std::sqrt(rest), dx = 2 * edge / kCells;
    const double cell = dx * 2 * b / kStrips;
    double t1 = 0, t2 = 0;
    for (int k = 0; k < kCells; ++k) {
      const double x = edge - (k + 0.5) * dx, way = k == 0 ? 0.5 * dx : dx;
      const double middle = x + 0.5 * way;
      t1 -= way * (slope1 - spin * y);
      t2 -= way * (slope2 + spin * middle);
      const double limit = most * (rest - x * x / (a * a)), size = std::sqrt(t1 * t1 + t2 * t2);
      if (size > limit) t1 *= limit / size, t2 *= limit / size;
      wrench.f1 += t1 * cell;
      wrench.f2 += t2 * cell;
      wrench.mn += (x * t2 - y * t1) * cell;
    }
  }
  return wrench;
}

}  // namespace bogie_curve
