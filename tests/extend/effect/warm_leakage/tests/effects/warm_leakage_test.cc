// The leak that opens with temperature: tight when cold, half open half way, the closed form of the
// pressure it loses.
#include <gtest/gtest.h>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

constexpr double kConductance = 1e-14;

/// Pressure of the rod's line after 10 s that are warmer by `kelvin`.
double After10s(double kelvin, double conductance) {
  PhsParams p =
      With(Frictionless(), "warm_leakage",
           {{"conductance_m3_per_Pas", conductance}, {"opens_K", 5}, {"range_K", 10}}, {"L1"});
  // Warmth of the surroundings alone: the oil neither expands nor softens.
  p = With(p, "temperature_drift",
           {{"rate_K_per_s", 10},
            {"start_s", -100},
            {"limit_K", kelvin},
            {"expansion_1_per_K", 0},
            {"softening_1_per_K", 0},
            {"amplitude_K", 0}});
  return Hold(Compile(p), 0, 10).p_rod;
}

TEST(WarmLeakage, OpensBetweenTwoTemperatures) {
  const auto lost = [](double kelvin) {
    return After10s(kelvin, 0) - After10s(kelvin, kConductance);
  };
  EXPECT_EQ(lost(4.9), 0);
  const double half = lost(10), open = lost(15);
  EXPECT_GT(open, 100);
  // The gas spring's pressure rises with the warmth too: by 10 and 15 K.
  EXPECT_NEAR(open / half, 2 * After10s(15, 0) / After10s(10, 0), 0.05);
  EXPECT_NEAR(lost(40) / open, After10s(40, 0) / After10s(15, 0), 0.2);
}

TEST(WarmLeakage, LosesWhatFlowsThroughTheGap) {
  const auto& line = Frictionless().lines[0];
  const double p = After10s(20, 0);
  const double C = line.oil_volume_m3 / line.bulk_modulus_Pa + line.gas_volume_m3 / p;
  const double expected = kConductance * (p - kAtmosphere) * 10 / C;
  EXPECT_NEAR(p - After10s(20, kConductance), expected, 0.1 * expected);
}

}  // namespace
}  // namespace phs::effects
