// Oil properties and pipe laws.
#include <gtest/gtest.h>

#include <cmath>

#include "hydraulics/oil.h"
#include "hydraulics/pipe.h"

namespace phs::hydraulics {
namespace {

TEST(Oil, ViscosityMeetsTheGradeAtFortyDegrees) {
  EXPECT_NEAR(CalcKinematicViscosity(313.15), 68e-6, 1e-9);
  EXPECT_NEAR(CalcKinematicViscosity(373.15), 8.7e-6, 1e-9);
  // Walther's chart for VG 68, VI 100: about 210 mm²/s at 20 °C and 900 at 0 °C.
  EXPECT_NEAR(CalcKinematicViscosity(293.15), 210e-6, 25e-6);
  EXPECT_GT(CalcKinematicViscosity(273.15), 650e-6);
  EXPECT_LT(CalcKinematicViscosity(273.15), 1100e-6);
  EXPECT_TRUE(std::isfinite(CalcKinematicViscosity(100)));
  double before = 1;
  for (double T = 253.15; T <= 323.15; T += 1) {
    EXPECT_LT(CalcKinematicViscosity(T), before);
    before = CalcKinematicViscosity(T);
  }
}

TEST(Oil, AirMattersAtLowPressureOnly) {
  // Tangent of the volume curve by finite difference.
  const double beta = 1.4e9, a = 0.01, n = 1.3;
  auto volume = [&](double p) { return std::exp(-p / beta) + a * std::pow(101325 / p, 1 / n); };
  for (double p : {2e5, 1e6, 5e6, 2e7}) {
    const double d = 1e-4 * p;
    const double K = -volume(p) * 2 * d / (volume(p + d) - volume(p - d));
    EXPECT_NEAR(CalcEffectiveBulkModulus(p, beta, a, n) / K, 1, 0.02) << p;
  }
  EXPECT_LT(CalcEffectiveBulkModulus(2e5, beta, a, n), 0.1 * beta);
  EXPECT_GT(CalcEffectiveBulkModulus(2e7, beta, a, n), 0.9 * beta);
}

TEST(Pipe, HagenPoiseuilleAndInertance) {
  const double mu = 0.06, l = 2, d = 0.012;
  EXPECT_NEAR(CalcLaminarResistance(mu, l, d), 128 * 0.06 * 2 / (M_PI * 2.0736e-8), 1e3);
  EXPECT_NEAR(CalcInertance(870, l, d), 870 * 2 / 1.13097e-4, 1e3);
}

TEST(Pipe, FlowIsTheInverseOfDropByDirectionAndInSeries) {
  const PipeFlow pipe({1e9, 1e14}, {5e9, 0}, 0);
  const auto series = InSeries(std::make_unique<PipeFlow>(pipe),
                               std::make_unique<PipeFlow>(PipeFlow::Resistance{2e9, 3e13},
                                                          PipeFlow::Resistance{2e9, 3e13}, 7));
  EXPECT_EQ(series->Inertance(), 7);
  for (double dp : {-3e6, -1e3, 0.0, 1.0, 2e5, 8e6}) {
    for (const FlowLaw* law :
         {static_cast<const FlowLaw*>(&pipe), static_cast<const FlowLaw*>(series.get())}) {
      double slope, rise;
      const double q = law->Flow({}, dp, &slope);
      EXPECT_NEAR(law->Drop({}, q, &rise), dp, 1e-6 * std::abs(dp) + 1e-9);
      EXPECT_NEAR(slope * rise, 1, 1e-6);
      EXPECT_GE(q * dp, 0) << "passive";
    }
  }
}

TEST(Pipe, ALeakOpensOverItsOpeningTime) {
  const GapFlow leak(1e-12, 1, 2);
  double slope;
  const auto flow = [&](double after) { return leak.Flow({.time = 2 + after}, 1e6, &slope); };
  EXPECT_EQ(flow(-1), 0);
  EXPECT_EQ(flow(0), 0);
  EXPECT_NEAR(flow(0.5 * GapFlow::kOpening), 0.5e-6, 1e-18);
  EXPECT_NEAR(slope, 0.5e-12, 1e-24);
  EXPECT_DOUBLE_EQ(flow(2 * GapFlow::kOpening), 1e-6);
}

TEST(Pipe, LaminarFlowFollowsTheViscosityAndTurbulentDoesNot) {
  const FlowPlace cold{.viscosity = 4};
  double slope, rise;
  const PipeFlow laminar({1e9, 0}, {1e9, 0}, 0), rough({1e-3, 1e14}, {1e-3, 1e14}, 0);
  EXPECT_DOUBLE_EQ(laminar.Flow(cold, 1e6, &slope), 1e6 / 4e9);
  EXPECT_DOUBLE_EQ(laminar.Drop(cold, 1e-4, &rise), 4e9 * 1e-4);
  EXPECT_NEAR(rough.Flow(cold, 1e6, &slope), 1e-4, 1e-12);
  for (const double exponent : {0.5, 0.75, 1.0, 1.5}) {
    const GapFlow gap(1e-12, exponent);
    const double share = std::min(2 * exponent - 1, 1.0);
    const double q = gap.Flow(cold, 3e6, &slope);
    EXPECT_NEAR(q / gap.Flow({}, 3e6, &slope), std::pow(4, -share), 1e-12) << exponent;
    EXPECT_NEAR(gap.Drop(cold, q, &rise), 3e6, 1) << exponent;
  }
}

}  // namespace
}  // namespace phs::hydraulics
