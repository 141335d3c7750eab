// Leaks that have a place in the stroke, and films that the rod carries out.
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

}  // namespace
}  // namespace phs::effects
