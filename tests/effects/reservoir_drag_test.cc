// Gas behind a separator that drags or a neck: closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

// While the gas is held the oil alone yields; beyond, the line stands P_f above what the gas has.
TEST(ReservoirDrag, HoldsTheGasUntilItsFriction) {
  const PhsParams params = Frictionless();
  const double P_f = 3e5;
  const PhsSystem s = Compile(With(params, "reservoir_drag", {{"friction_Pa", P_f}}));
  const auto& l = params.lines[1];
  const double area = params.cylinders[0].BoreArea(), oil = l.oil_volume_m3 / l.bulk_modulus_Pa;
  const double small = -0.9 * P_f * 0.99 * oil / area;
  EXPECT_NEAR(Hold(s, small, 1).p_bore - l.static_pressure_Pa, 0.9 * P_f, 1e-3 * P_f);
  for (const double sign : {-1.0, 1.0}) {  // pushed in, drawn out
    const double x = sign * 8e-4;
    const double p = Drive(s, 1, 1e-3, [x](double t) { return x * t; }).p_bore;
    const double gas = p + sign * P_f;
    const double taken = 0.99 * oil * (p - l.static_pressure_Pa) +
                         0.01 * oil * (gas - l.static_pressure_Pa) +
                         l.gas_volume_m3 * (1 - l.static_pressure_Pa / gas);
    EXPECT_NEAR(taken / (-x * area), 1, 1e-3) << x;
  }
}

// In steps of 20 ms beside a mounting: the line stands P_f above the gas while it is pushed in, P_f
// below it on the way back, and the mounting carries what the pressures give.
TEST(ReservoirDrag, SlidesInLongStepsBesideAMounting) {
  const double P_f = 1e5, h = 0.02, k = 5e7;
  const PhsParams params = With(Frictionless(), "mount_compliance", {{"stiffness_N_per_m", k}});
  const PhsSystem s = Compile(With(params, "reservoir_drag", {{"friction_Pa", P_f}}));
  const auto& l = params.lines[1];
  const double area = params.cylinders[0].BoreArea(), oil = l.oil_volume_m3 / l.bulk_modulus_Pa;
  const auto motion = [](double t) { return -1.5e-3 * std::sin(3 * t); };
  for (const double t : {0.2, 0.4, 0.8, 0.9, 1.24, 1.4}) {
    const Held at = Drive(s, t, h, motion);
    const double sign = std::cos(3 * t) > 0 ? 1 : -1;  // pushed in, drawn out
    const double gas = at.p_bore - sign * P_f;
    const double taken = 0.99 * oil * (at.p_bore - l.static_pressure_Pa) +
                         0.01 * oil * (gas - l.static_pressure_Pa) +
                         l.gas_volume_m3 * (1 - l.static_pressure_Pa / gas);
    EXPECT_NEAR(taken / (-at.piston * area), 1, 5e-3) << t;
    EXPECT_NEAR(k * (motion(t) - at.piston) / at.force, 1, 5e-3) << t;
  }
}

// A neck: the line relaxes to the gas with R times the compliances of both in series.
TEST(ReservoirDrag, ANeckLetsThePressureRelax) {
  const PhsParams params = Frictionless();
  const double R = 2e11;
  const PhsSystem s =
      Compile(With(params, "reservoir_drag", {{"friction_Pa", 0}, {"laminar_Pas_per_m3", R}}));
  const auto& l = params.lines[1];
  const double C_oil = 0.99 * l.oil_volume_m3 / l.bulk_modulus_Pa;
  const double C_gas = l.gas_volume_m3 / l.static_pressure_Pa + C_oil / 99;
  const double tau = R * C_oil * C_gas / (C_oil + C_gas), x = -2e-7;
  const double rest = l.static_pressure_Pa;
  const double settled = Hold(s, x, 20 * tau, tau / 200).p_bore - rest;
  const double begun = Hold(s, x, 0).p_bore - rest;
  EXPECT_NEAR(settled * (C_oil + C_gas) / (begun * C_oil), 1, 1e-3);
  const double later = Hold(s, x, tau, tau / 1000).p_bore - rest;
  EXPECT_NEAR((later - settled) / (begun - settled), std::exp(-1.0), 2e-3);
}

// An edge: with oil that does not yield, gas follows the piston and the line stands K q² above it.
TEST(ReservoirDrag, AnEdgeTakesTheSquareOfTheFlow) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.bulk_modulus_Pa = 1e11, l.oil_volume_m3 = 1e-4;
  const double K = 5e13, v = -5e-3;
  const PhsSystem s =
      Compile(With(params, "reservoir_drag", {{"friction_Pa", 0}, {"turbulent_Pas2_per_m6", K}}));
  const auto& l = params.lines[1];
  const double area = params.cylinders[0].BoreArea(), q = -area * v;
  const double p = Drive(s, 0.1, 1e-4, [v](double t) { return v * t; }).p_bore;
  const double gas = l.static_pressure_Pa * l.gas_volume_m3 / (l.gas_volume_m3 - q * 0.1);
  EXPECT_NEAR((p - gas) / (K * q * q + 1e7 * q), 1, 5e-3);
}

}  // namespace
}  // namespace phs::effects
