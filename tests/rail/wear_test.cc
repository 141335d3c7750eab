#include "rail/wear.h"

#include <gtest/gtest.h>

#include <numbers>

#include "rail/running_safety.h"

namespace phs::rail {
namespace {

TEST(TGamma, SplitsSlipAndSpin) {
  CreepInput c;
  c.xi = -2e-3;
  c.eta = 1e-3;
  c.phi = 0.5;
  const TGamma t = CalcTGamma(c, {10e3, -8e3, -6});
  EXPECT_DOUBLE_EQ(t.slip, 28);
  EXPECT_DOUBLE_EQ(t.spin, 3);
}

// Pearce, Sherratt 1991: three regimes, D in mm.
TEST(Wear, BritishRailRegimes) {
  EXPECT_DOUBLE_EQ(CalcWornAreaPerKm(0, 1.25), 0);
  EXPECT_NEAR(CalcWornAreaPerKm(40, 1.25), 0.25 * 40 / 1250, 1e-15);
  EXPECT_NEAR(CalcWornAreaPerKm(150, 1.25), 25.0 / 1250, 1e-15);
  EXPECT_NEAR(CalcWornAreaPerKm(300, 1.25), (1.19 * 300 - 154) / 1250, 1e-15);
  EXPECT_NEAR(CalcWornAreaPerKm(100, 1), CalcWornAreaPerKm(100.001, 1), 1e-6);
  EXPECT_STREQ(NameOf(WearRegimeOf(99)), "mild");
  EXPECT_STREQ(NameOf(WearRegimeOf(101)), "severe");
  EXPECT_STREQ(NameOf(WearRegimeOf(201)), "catastrophic");
}

// Lewis, Dwyer-Joyce 2004: 5.3 ug/(m mm^2) per N/mm^2, plateau of 55, 61.9 beyond; continuous.
TEST(Wear, SheffieldRegimes) {
  const double area = 100e-6;  // 100 mm^2
  EXPECT_NEAR(CalcSheffieldWearRate(500, area), 26.5, 1e-9);
  EXPECT_NEAR(CalcSheffieldWearRate(5000, area), 55, 1e-9);
  EXPECT_NEAR(CalcSheffieldWearRate(10e3, area), 61.9 * 22.8 + 55, 1e-9);
  EXPECT_NEAR(CalcSheffieldWearRate(1040, area), 55, 0.2);
}

// Whole life rail model: zero below 20 N, 1e-5 at 65 N, zero at 175 N; printed straight lines
// 2.22e-7 T - 4.44e-6 and -9.09e-8 T + 1.59e-5.
TEST(Rcf, WholeLifeRailModel) {
  EXPECT_EQ(CalcRcfDamage(20, false), 0);
  EXPECT_NEAR(CalcRcfDamage(40, false), 2.22e-7 * 40 - 4.44e-6, 1e-8);
  EXPECT_DOUBLE_EQ(CalcRcfDamage(65, false), 1e-5);
  EXPECT_NEAR(CalcRcfDamage(120, false), -9.09e-8 * 120 + 1.59e-5, 1e-8);
  EXPECT_NEAR(CalcRcfDamage(175, false), 0, 1e-18);
  EXPECT_EQ(CalcRcfDamage(300, false), 0);
  EXPECT_NEAR(CalcRcfDamage(285, true), -1e-5, 1e-15);
}

// Nadal's formula, published values to three digits.
TEST(RunningSafety, NadalLimit) {
  const double degree = std::numbers::pi / 180;
  EXPECT_NEAR(CalcNadalLimit(60 * degree, 0.3), 0.942, 5e-4);
  EXPECT_NEAR(CalcNadalLimit(65 * degree, 0.3), 1.122, 5e-4);
  EXPECT_NEAR(CalcNadalLimit(70 * degree, 0.3), 1.342, 5e-4);
  EXPECT_NEAR(CalcNadalLimit(60 * degree, 0.4), 0.787, 5e-4);
  EXPECT_NEAR(CalcNadalLimit(70 * degree, 0.4), 1.118, 5e-4);
}

// 26 t axle: Q0 = 127.5 kN gives 95.0 kN, 80.8 kN with k1 = 0.85.
TEST(RunningSafety, TrackShiftLimit) {
  EXPECT_NEAR(CalcTrackShiftLimit(127.5e3, 1), 95.0e3, 50);
  EXPECT_NEAR(CalcTrackShiftLimit(127.5e3, 0.85), 80.75e3, 50);
}

}  // namespace
}  // namespace phs::rail
