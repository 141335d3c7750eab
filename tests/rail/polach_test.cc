#include "rail/polach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "creep_reference.h"
#include "rail/creep_conditions.h"

namespace phs::rail {
namespace {

// Separate evaluation of the closed form (kA = kS = 1) on 141 cases, which is not cut at mu N.
TEST(Polach, ClosedFormEvaluatedElsewhereWithin1e5OfMuN) {
  const Table t = ReferenceTable("hertz_creep_table.csv");
  for (int i = 0; i < t.num_rows(); ++i) {
    const CreepInput in = HertzCase(t, i);
    const CreepForce f =
        CalcPolach(in, CalcKalkerCoefficients(Cell(t, "a_over_b", i), 0.28), 82e9, 1, 1);
    double x = Cell(t, "Fx_Polach1999_N", i);
    double y = Cell(t, "Fy_Polach1999_N", i);
    const double limit = in.friction * in.normal;
    const double over = std::max(1.0, std::hypot(x, y) / limit);
    EXPECT_NEAR(f.x, x / over, 1e-5 * limit) << i;
    EXPECT_NEAR(f.y, y / over, 1e-5 * limit) << i;
  }
}

TEST(Polach, LinearLimitIsKalkersTimesTheFactors) {
  CreepInput in;
  in.a = 6e-3;
  in.b = 5e-3;
  in.normal = 1e5;
  in.xi = 1e-9;
  const KalkerCoefficients c = CalcKalkerCoefficients(1.2, 0.28);
  const double linear = -82e9 * in.a * in.b * c.c11 * in.xi;
  // (2/pi)(kA + kS) e with e = G pi a b C11 xi/(4 f N): the mean of kA and kS.
  EXPECT_NEAR(CalcPolach(in, c, 82e9, 1, 1).x, linear, 1e-6 * std::abs(linear));
  EXPECT_NEAR(CalcPolach(in, c, 82e9, 0.3, 0.1).x, 0.2 * linear, 1e-6 * std::abs(linear));
}

// The sum of both terms passes mu N where kS is much larger than kA (here 5 and 1): it is cut there.
TEST(Polach, NeverMoreThanFrictionAllows) {
  const KalkerCoefficients c = CalcKalkerCoefficients(1.2, 0.28);
  CreepInput in;
  in.a = 6e-3;
  in.b = 5e-3;
  in.normal = 1e5;
  in.friction = 0.3;
  double largest = 0;
  for (const double xi : {-0.02, -5e-3, -1e-3, -2e-4, 0.0, 5e-3}) {
    for (const double eta : {-0.03, -4e-3, -1e-3, 0.0, 2e-4, 1e-3, 4e-3, 0.02}) {
      for (const double phi : {-9.0, -2.0, -0.5, -0.1, 0.3, 1.0, 4.0}) {
        in.xi = xi;
        in.eta = eta;
        in.phi = phi;
        const CreepForce f = CalcPolach(in, c, 82e9, 1, 5);
        largest = std::max(largest, std::hypot(f.x, f.y) / 3e4);
      }
    }
  }
  EXPECT_NEAR(largest, 1, 1e-12);
}

// Polach 2005: falling friction gives a maximum, and less force beyond it.
TEST(Polach, FallingFrictionGivesAnOptimalCreepage) {
  const auto wet = FindFrictionCondition("wet_traction");
  ASSERT_TRUE(wet.ok());
  CreepLawParams p;
  p.method = "polach";
  p.polach_adhesion = wet.value().polach_adhesion;
  p.polach_slip = wet.value().polach_slip;
  const auto law = Law(p);
  CreepInput in{7e-3, 5e-3, 1e5, 0, 0, 0, 20, 0.3};
  double best = 0, best_xi = 0, last = 0;
  for (double xi = 1e-4; xi < 0.3; xi *= 1.05) {
    in.xi = xi;
    in.friction = wet.value().tread.At(in.speed * xi);
    last = -law->Calc(in).x;
    if (last > best) {
      best = last;
      best_xi = xi;
    }
  }
  EXPECT_GT(best_xi, 0.01);
  EXPECT_LT(best_xi, 0.1);
  EXPECT_LT(last, 0.95 * best);
}

TEST(FrictionLaw, FallsFromTheStaticToTheLimitValue) {
  const FrictionLaw f{0.36, 0.38, 0.7};
  EXPECT_DOUBLE_EQ(f.At(0), 0.36);
  EXPECT_NEAR(f.At(1), 0.36 * (0.62 * std::exp(-0.7) + 0.38), 1e-15);
  EXPECT_NEAR(f.At(1e3), 0.36 * 0.38, 1e-12);
  EXPECT_DOUBLE_EQ(FrictionLaw{}.At(5), 0.3);
}

TEST(FrictionCondition, UnknownNameListsTheKnown) {
  const auto none = FindFrictionCondition("ice");
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.error().Line().find("flange_lubricated"), std::string::npos);
}

}  // namespace
}  // namespace phs::rail
