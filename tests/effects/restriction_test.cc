// The law between a chamber and its line, against closed formulas.
#include "effects/restriction.h"

#include <gtest/gtest.h>

#include <cmath>

namespace phs::effects {
namespace {

using hydraulics::PipeFlow;

constexpr double kR = 1e10, kAway = 4;  ///< out of the chamber; into it over that

std::unique_ptr<hydraulics::FlowLaw> Law(double exponent, double turbulent = 0, double warmer = 0) {
  hydraulics::PhsParams params;
  params.temperature_K = 293.15 + warmer;
  return MakeRestriction({kR, turbulent}, {kAway * kR, turbulent}, exponent, params);
}

TEST(Restriction, WithoutAnExponentItIsThePipe) {
  double slope, pipe_slope;
  const PipeFlow pipe({kR, 1e14}, {kAway * kR, 1e14}, 0);
  for (const double dp : {-3e6, 1e4, 2e6}) {
    EXPECT_EQ(Law(1, 1e14)->Flow({}, dp, &slope), pipe.Flow({}, dp, &pipe_slope)) << dp;
    EXPECT_EQ(slope, pipe_slope) << dp;
  }
}

TEST(Restriction, WhatTheFlowLiftsPassesThePowerOfItsDrop) {
  // q = q0 (dp/(R q0))^n by direction: q0 at R q0, and 3^n times as much at three times the drop.
  double slope;
  constexpr double q0 = kRestrictionFlow;
  for (const double n : {1.3, 1.8, 4.0}) {
    const auto law = Law(n);
    EXPECT_NEAR(law->Flow({}, kR * q0, &slope) / q0, 1, 3e-3) << n;
    EXPECT_NEAR(law->Flow({}, -kAway * kR * q0, &slope) / q0, -1, 3e-3) << n;
    EXPECT_NEAR(law->Flow({}, 3 * kR * q0, &slope) / q0, std::pow(3, n), 3e-3 * std::pow(3, n))
        << n;
    // The flow follows the viscosity of warm oil, at rest and in the record.
    const double cold = law->Flow({}, 2e5, &slope);
    EXPECT_NEAR(law->Flow({.viscosity = 0.5}, 2e5, &slope) / cold, 2, 1e-9) << n;
    EXPECT_NEAR(Law(n, 0, 20)->Flow({}, 2e5, &slope) / cold,
                Law(1, 0, 20)->Flow({}, 2e5, &slope) / Law(1)->Flow({}, 2e5, &slope), 1e-9)
        << n;
  }
}

TEST(Restriction, TurbulenceStandsBehindIt) {
  // Drops of both add: dp = R q0 (q/q0)^(1/n) + K q².
  constexpr double q = 3e-5, K = 1e14, n = 2, dp = kR * kRestrictionFlow * 1.7320508 + K * q * q;
  double slope, rise;
  const auto law = Law(n, K);
  EXPECT_NEAR(law->Flow({}, dp, &slope) / q, 1, 2e-3);
  EXPECT_NEAR(law->Drop({}, q, &rise) / dp, 1, 2e-3);
  EXPECT_NEAR(slope * rise, 1, 5e-3);
}

// A valve held shut: once lifted, at some 1e-5 m3/s, it takes its spring's pressure by direction.
TEST(Restriction, AValveHeldShutTakesItsSpringsPressure) {
  constexpr double R = 1e8, out = 2e5, in = 5e4;
  const auto law = MakeRestriction({R, 0, out}, {R, 0, in}, 1, {});
  double slope, rise;
  for (const double q : {-3e-4, -1e-5, 2e-6, 1e-5, 3e-4}) {
    const double P = q > 0 ? out : in, dp = R * q + P * q / std::hypot(q, kRestrictionFlow);
    EXPECT_NEAR(law->Drop({}, q, &rise) / dp, 1, 1e-12) << q;
    EXPECT_NEAR(law->Flow({}, dp, &slope) / q, 1, 1e-9) << q;
    EXPECT_NEAR(slope * rise, 1, 1e-9) << q;
    const double nudge = 1e-4 * q;
    const double above = law->Drop({}, q + nudge, &slope), below = law->Drop({}, q - nudge, &slope);
    EXPECT_NEAR((above - below) / (2 * nudge) / rise, 1, 1e-6) << q;
  }
  EXPECT_NEAR(law->Drop({}, 3e-4, &rise), out + R * 3e-4, 1e-3 * out);
}

// A power of the drop, turbulence and a valve's spring together: flow and drop are inverses of each
// other by direction from pascals to tens of megapascals, with slopes that are, too.
TEST(Restriction, FlowAndDropAreInverses) {
  for (const double n : {0.5, 0.7, 1.3, 2.0, 4.0}) {
    for (const double spring : {0.0, 2e5}) {
      for (const double K : {0.0, 1e14}) {
        const auto law = MakeRestriction({kR, K, spring}, {kAway * kR, 2 * K, spring / 4}, n, {});
        for (double dp = 3; dp < 3e7; dp *= 7) {
          for (const double d : {dp, -dp}) {
            double slope, rise, other;
            const double q = law->Flow({.viscosity = 0.8}, d, &slope);
            EXPECT_NEAR(law->Drop({.viscosity = 0.8}, q, &rise) / d, 1, 1e-12) << n << " " << d;
            EXPECT_NEAR(slope * rise, 1, 1e-7) << n << " " << d;
            const double above = law->Drop({.viscosity = 0.8}, q * (1 + 1e-4), &other);
            const double below = law->Drop({.viscosity = 0.8}, q * (1 - 1e-4), &other);
            EXPECT_NEAR((above - below) / (2e-4 * q) / rise, 1, 1e-6) << n << " " << d;
          }
        }
        double slope, rise;
        EXPECT_EQ(law->Flow({}, 0, &slope), 0);
        EXPECT_EQ(law->Drop({}, 0, &rise), 0);
        EXPECT_NEAR(slope * rise, 1, 1e-12) << n;
      }
    }
  }
}

}  // namespace
}  // namespace phs::effects
