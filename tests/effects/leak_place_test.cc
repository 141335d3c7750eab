// Leaks that have a place in the stroke, films that the rod carries out, valves that feed a line.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

// A scored length: it leaks as anywhere where the piston stands on it, half as much at its edge.
TEST(LeakPlace, AScoredBoreLeaksWhereThePistonStandsOnIt) {
  const PhsParams params = Frictionless();
  const double G = 1e-14;
  const auto lost = [&](double x, double edge) {
    const PhsSystem s =
        Compile(With(params, "piston_leakage",
                     {{"conductance_m3_per_Pas", G}, {"from_m", 1e-3}, {"edge_m", edge}}));
    return Hold(s, x, 0.01, 1e-4).state[0];  // the volume that passed, before the pressures move
  };
  for (const double x : {-1e-3, 0.0, 1e-3, 2e-3}) {
    const double everywhere = lost(x, 0);
    EXPECT_NEAR(lost(x, 1e-4) / everywhere, x > 1.5e-3 ? 1 : x > 0.5e-3 ? 0.5 : 0, 1e-3) << x;
    EXPECT_NEAR(lost(x, -1e-4) / everywhere, x > 1.5e-3 ? 0 : x > 0.5e-3 ? 0.5 : 1, 1e-3) << x;
  }
}

TEST(LeakPlace, APortThatThePistonUncoversEmptiesItsLine) {
  const PhsSystem s =
      Compile(With(Frictionless(), "external_leakage",
                   {{"conductance_m3_per_Pas", 1e-6}, {"from_m", 1e-3}, {"edge_m", 1e-5}}, {"L1"}));
  EXPECT_GT(Hold(s, 0.9e-3, 2).p_rod, 2e6);
  EXPECT_NEAR(Hold(s, 1.1e-3, 2).p_rod, kAtmosphere, 1e3);
}

// Three strokes of 1 mm lose h_out times 3 mm; what is brought back is h_in times the same.
TEST(LeakPlace, AFilmIsCarriedOutWithEachStroke) {
  const double out = 2e-7, in = 5e-8;
  const auto carried = [&](double h_out, double h_in) {
    const PhsSystem s = Compile(With(
        Frictionless(), "external_leakage",
        {{"conductance_m3_per_Pas", 0}, {"film_out_m2", h_out}, {"film_in_m2", h_in}}, {"L1"}));
    return Drive(s, 3, 1e-3, [](double t) { return 0.5e-3 * (1 - std::cos(2 * M_PI * t)); })
        .state[0];
  };
  EXPECT_NEAR(carried(out, 0) / (3e-3 * out), 1, 1e-3);
  EXPECT_NEAR(carried(0, in) / (-3e-3 * in), 1, 1e-3);
  EXPECT_NEAR(carried(out, in) / (3e-3 * (out - in)), 1, 1e-3);
}

// Below its opening it feeds by q = G d (d/5 MPa)^(n-1), above it does nothing.
TEST(MakeupValve, FeedsItsLineBelowItsOpening) {
  const double G = 2e-14, time = 1e-3;
  for (const double n : {0.5, 1.0, 1.7}) {
    for (const double opening : {2.3e6, 1.5e6, 4e6}) {  // the bore line is filled to 1.8 MPa
      const PhsSystem s = Compile(
          With(Frictionless(), "makeup_valve",
               {{"conductance_m3_per_Pas", G}, {"opening_Pa", opening}, {"exponent", n}}, {"L2"}));
      const double d = std::max(opening - 1.8e6, 0.0);
      const double fed = d > 0 ? G * d * std::pow(d / 5e6, n - 1) * time : 0;
      EXPECT_NEAR(-Hold(s, 0, time, time / 10).state[0], fed, 1e-4 * fed) << n << " " << opening;
    }
  }
}

// A chamber that is pulled out is filled up to the opening, and what came in does not go again.
TEST(MakeupValve, FillsUpToItsOpeningAndLetsNothingOut) {
  const PhsSystem s =
      Compile(With(Frictionless(), "makeup_valve",
                   {{"conductance_m3_per_Pas", 1e-9}, {"opening_Pa", 1.2e6}}, {"L2"}));
  const double out = 4e-3;
  EXPECT_LT(Hold(Compile(Frictionless()), out, 1).p_bore, 1.1e6);
  const Held filled = Hold(s, out, 1);
  EXPECT_NEAR(filled.p_bore, 1.2e6, 1e3);
  const Held back = Drive(s, 2, 1e-3, [&](double t) { return t < 1 ? out : 0; });
  EXPECT_NEAR(back.state[0] / filled.state[0], 1, 1e-6);
  EXPECT_GT(back.p_bore, 2e6) << "more oil than before";
}

}  // namespace
}  // namespace phs::effects
