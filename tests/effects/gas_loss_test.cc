// Gas that leaves a reservoir: closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

PhsParams GasAlone() {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.bulk_modulus_Pa = 1e11;
  return params;
}

// Gas alone in a room that keeps its size: p = p0 (1 - m), and a loss that goes with the pressure
// gives p = p0 exp(-r t).
TEST(GasLoss, APinholeEmptiesTheReservoirExponentially) {
  const PhsParams params = GasAlone();
  const double r = 0.05, p0 = params.lines[0].static_pressure_Pa;
  const PhsSystem s = Compile(With(params, "gas_loss", {{"loss_1_per_s", r}}, {"L1"}));
  EXPECT_NEAR(Hold(s, 0, 0).p_rod / p0, 1, 1e-9);
  const Held later = Hold(s, 0, 1 / r, 1e-2);
  EXPECT_NEAR(later.p_rod / p0, std::exp(-1), 1e-3);
  EXPECT_NEAR(later.p_bore, 1.8e6, 1e-3) << "the other line keeps its gas";
}

// p held by nothing but the rest of the gas: dm/dt = r, so p = p0 (1 - r t).
TEST(GasLoss, ASteadyLossFallsStraight) {
  const PhsParams params = GasAlone();
  const double r = 0.02, p0 = params.lines[1].static_pressure_Pa;
  const PhsSystem s =
      Compile(With(params, "gas_loss", {{"loss_1_per_s", r}, {"exponent", 0}}, {"L2"}));
  EXPECT_NEAR(Hold(s, 0, 20, 1e-2).p_bore / p0, 1 - 20 * r, 1e-3);
}

TEST(GasLoss, AValveThatUnseatsLosesNothingBelowItsPressure) {
  const PhsParams params = Frictionless();
  const PhsSystem s =
      Compile(With(params, "gas_loss", {{"loss_1_per_s", 0.02}, {"start_Pa", 3e6}}, {"L1"}));
  const double rest = Hold(Compile(params), 2e-4, 0).p_rod;
  ASSERT_LT(rest, 3e6);
  EXPECT_NEAR(Hold(s, 2e-4, 20, 1e-2).p_rod, rest, 1);
  // Beyond it until the pressure has come down to it.
  ASSERT_GT(Hold(s, 2e-3, 0).p_rod, 3.5e6);
  EXPECT_NEAR(Hold(s, 2e-3, 3000, 0.1).p_rod, 3e6, 1e4);
}

}  // namespace
}  // namespace phs::effects
