#include "rail/hertz.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "creep_reference.h"

namespace phs::rail {
namespace {

constexpr double kG = 82e9;
constexpr double kNu = 0.28;

// Ellipse coefficients m, n, r over theta, from complete elliptic integrals (five digits).
TEST(Hertz, MeetsTheTableOfEllipticIntegralsWithin2e4) {
  const Table t = ReferenceTable("hertz_m_n_table.csv");
  const Hertz hertz(kG, kNu);
  const double e_star = kG / (1 - kNu);
  int compared = 0;
  for (int row = 0; row < t.num_rows(); ++row) {
    const auto cell = [&](size_t i) { return t.columns[i][static_cast<size_t>(row)]; };
    const double cosine = cell(1);
    if (cosine > 0.9999) continue;  // five digits of the cosine are too few there
    const double sum = 5;           // A + B [1/m]
    const double small = sum * (1 - std::cos(cell(0) * std::numbers::pi / 180)) / 2;
    const HertzContact c = hertz.AtApproach(1e-4, small, sum - small);
    // a0 = [3 N (1 - nu^2)/(2 E (A + B))]^(1/3) = [3 N/(4 E* (A + B))]^(1/3), E* = G/(1 - nu).
    const double a0 = std::cbrt(3 * c.normal / (4 * e_star * sum));
    EXPECT_NEAR(c.a / a0 / cell(2), 1, 2e-4) << "theta " << cell(0);
    EXPECT_NEAR(c.b / a0 / cell(3), 1, 2e-4) << "theta " << cell(0);
    EXPECT_NEAR(1e-4 / (a0 * a0 * sum) / cell(5), 1, 2e-4) << "theta " << cell(0);
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

// CONTACT prints approach 0.09267 mm and 1223 MPa for a 8, b 4 mm, N 82 kN, G 82 GPa, nu 0.28.
TEST(Hertz, MeetsContactsEllipse) {
  const Hertz hertz(kG, kNu);
  // Curvatures that give a/b = 2: found by bisection, then scaled to a = 8 mm.
  double low = 1, high = 100;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    const HertzContact c = hertz.AtApproach(1e-4, 1, middle);
    (c.a / c.b < 2 ? low : high) = middle;
  }
  double scale_low = 1e-2, scale_high = 1e2;
  HertzContact c;
  double approach = 0;
  for (int i = 0; i < 80; ++i) {
    const double scale = std::sqrt(scale_low * scale_high);
    approach = hertz.ApproachUnder(82e3, scale, low * scale);
    c = hertz.AtApproach(approach, scale, low * scale);
    (c.a > 8e-3 ? scale_low : scale_high) = scale;
  }
  EXPECT_NEAR(c.normal, 82e3, 1);
  EXPECT_NEAR(c.b, 4e-3, 1e-7);
  EXPECT_NEAR(approach * 1e3, 0.09267, 2e-5);
  EXPECT_NEAR(c.peak_pressure * 1e-6, 1223, 1);
}

TEST(Hertz, SphereOnPlane) {
  const Hertz hertz(kG, kNu);
  const double radius = 0.5;
  const double delta = 7e-5;
  const HertzContact c = hertz.AtApproach(delta, 0.5 / radius, 0.5 / radius);
  // Johnson 1985, eq. 4.23: N = (4/3) E' sqrt(R) delta^1.5, 1/E' = 2 (1 - nu^2)/E, a^2 = R delta.
  const double e = 2 * kG * (1 + kNu);
  const double e_prime = e / (2 * (1 - kNu * kNu));
  EXPECT_NEAR(c.normal / (4.0 / 3 * e_prime * std::sqrt(radius) * std::pow(delta, 1.5)), 1, 1e-6);
  EXPECT_NEAR(c.a, std::sqrt(radius * delta), 1e-9);
  EXPECT_NEAR(c.b, c.a, 1e-9);
}

TEST(Hertz, TurnedContactSwapsItsAxesAndNothingElse) {
  const Hertz hertz(kG, kNu);
  for (const double ratio : {1.0, 1.3, 4.0, 60.0, 3000.0}) {
    const HertzContact c = hertz.AtApproach(5e-5, 1, ratio);
    const HertzContact d = hertz.AtApproach(5e-5, ratio, 1);
    EXPECT_DOUBLE_EQ(c.a, d.b);
    EXPECT_DOUBLE_EQ(c.b, d.a);
    EXPECT_DOUBLE_EQ(c.normal, d.normal);
  }
}

TEST(Hertz, NoForceWithoutApproach) {
  const Hertz hertz(kG, kNu);
  EXPECT_EQ(hertz.AtApproach(0, 1, 1).normal, 0);
  EXPECT_EQ(hertz.AtApproach(-1e-6, 1, 1).normal, 0);
  EXPECT_EQ(hertz.ApproachUnder(0, 1, 1), 0);
}

}  // namespace
}  // namespace phs::rail
