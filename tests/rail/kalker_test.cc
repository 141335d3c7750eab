#include "rail/kalker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "creep_reference.h"

namespace phs::rail {
namespace {

TEST(Kalker, EveryRowOfKalker1990TableE3) {
  const Table t = ReferenceTable("kalker_coefficients.csv");
  ASSERT_EQ(t.num_rows(), 57);
  for (int i = 0; i < t.num_rows(); ++i) {
    const KalkerCoefficients c = CalcKalkerCoefficients(Cell(t, "a_over_b", i), Cell(t, "nu", i));
    EXPECT_NEAR(c.c11, Cell(t, "C11", i), 1e-4 * c.c11) << i;
    EXPECT_NEAR(c.c22, Cell(t, "C22", i), 1e-4 * c.c22) << i;
    EXPECT_NEAR(c.c23, Cell(t, "C23_eq_minus_C32", i), 1e-4 * c.c23) << i;
    EXPECT_NEAR(c.c33, Cell(t, "C33", i), 1e-4 * c.c33) << i;
  }
}

// CONTACT's rule (1/C quadratic in nu) at nu = 0.28, a = b, worked out by hand.
TEST(Kalker, InverseInterpolationInPoissonRatio) {
  const KalkerCoefficients c = CalcKalkerCoefficients(1, 0.28);
  EXPECT_NEAR(c.c11, 4.2262, 5e-5);
  EXPECT_NEAR(c.c22, 3.7049, 5e-5);
  EXPECT_NEAR(c.c23, 1.4881, 5e-5);
}

TEST(Kalker, LinearInSmallerRatioBetweenRows) {
  const KalkerCoefficients low = CalcKalkerCoefficients(1 / 0.5, 0.25);
  const KalkerCoefficients high = CalcKalkerCoefficients(1 / 0.6, 0.25);
  const KalkerCoefficients middle = CalcKalkerCoefficients(1 / 0.55, 0.25);
  EXPECT_NEAR(middle.c11, 0.5 * (low.c11 + high.c11), 1e-12);
  EXPECT_NEAR(middle.c23, 0.5 * (low.c23 + high.c23), 1e-12);
}

TEST(Kalker, ContinuousOverTheEndsOfTheTable) {
  for (double nu : {0.0, 0.25, 0.28, 0.5}) {
    for (double edge : {0.1, 10.0, 1.0}) {
      const KalkerCoefficients p = CalcKalkerCoefficients(edge * (1 - 1e-9), nu);
      const KalkerCoefficients q = CalcKalkerCoefficients(edge * (1 + 1e-9), nu);
      EXPECT_NEAR(p.c11, q.c11, 1e-6 * p.c11) << edge << " " << nu;
      EXPECT_NEAR(p.c22, q.c22, 1e-6 * p.c22) << edge << " " << nu;
      EXPECT_NEAR(p.c23, q.c23, 1e-6 * p.c23) << edge << " " << nu;
      EXPECT_NEAR(p.c33, q.c33, 1e-6 * p.c33) << edge << " " << nu;
    }
  }
}

// Kalker's limit for a very narrow contact: C22 -> pi^2/4, C11 -> pi^2/(4 (1 - nu)).
TEST(Kalker, NarrowContactApproachesStripTheory) {
  const KalkerCoefficients c = CalcKalkerCoefficients(0.002, 0.25);
  EXPECT_NEAR(c.c22, M_PI * M_PI / 4, 0.03 * c.c22);
  EXPECT_NEAR(c.c11, M_PI * M_PI / 3, 0.03 * c.c11);
  EXPECT_LT(c.c23, CalcKalkerCoefficients(0.1, 0.25).c23);
}

TEST(Kalker, CurveOfOneMaterialFollowsTheRule) {
  const KalkerCurve curve(0.28);
  for (double ratio = 0.02; ratio < 50; ratio *= 1.07) {
    const KalkerCoefficients p = CalcKalkerCoefficients(ratio, 0.28);
    const KalkerCoefficients q = curve.At(ratio);
    EXPECT_NEAR(q.c11, p.c11, 1e-3 * p.c11) << ratio;
    EXPECT_NEAR(q.c22, p.c22, 1e-3 * p.c22) << ratio;
    EXPECT_NEAR(q.c23, p.c23, 1.5e-3 * p.c23) << ratio;
    EXPECT_NEAR(q.c33, p.c33, 2e-3 * p.c33) << ratio;
  }
}

TEST(Kalker, LinearLawHasKalkersSignsAndCoupling) {
  const KalkerCoefficients c{4, 3.5, 1.5, 1.2};
  CreepInput in;
  in.a = 6e-3;
  in.b = 4e-3;
  in.normal = 1e5;
  const double g = 82e9;
  const double ab = in.a * in.b;
  in.eta = 1e-5;
  CreepForce f = CalcLinearCreep(in, c, g);
  EXPECT_DOUBLE_EQ(f.y, -g * ab * 3.5 * 1e-5);
  EXPECT_DOUBLE_EQ(f.moment, g * std::pow(ab, 1.5) * 1.5 * 1e-5);
  in.eta = 0;
  in.phi = 1e-3;
  f = CalcLinearCreep(in, c, g);
  EXPECT_NEAR(f.y, -g * std::pow(ab, 1.5) * 1.5 * 1e-3, 1e-9);
  EXPECT_NEAR(f.moment, -g * ab * ab * 1.2 * 1e-3, 1e-12);
}

}  // namespace
}  // namespace phs::rail
