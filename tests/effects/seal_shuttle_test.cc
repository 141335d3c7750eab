// A piston seal that gives way in its groove: closed forms of what it carries, and when.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

// Without gas a line holds V_oil (p - p0)/beta, from which the volume that the ring carried follows.
double CarriedToRod(const PhsParams& params, const Held& at, double x) {
  const auto& rod = params.lines[0];
  return rod.oil_volume_m3 * (at.p_rod - rod.static_pressure_Pa) / rod.bulk_modulus_Pa -
         params.cylinders[0].RodArea() * x;
}

TEST(SealShuttle, CarriesWhatItsGrooveHolds) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double at_rest = params.lines[1].static_pressure_Pa - params.lines[0].static_pressure_Pa;
  for (const auto& [V, P] : {std::pair(4e-7, 1.5e6), {8e-6, 3e7}}) {
    const PhsSystem s = Compile(With(params, "seal_shuttle", {{"volume_m3", V}, {"width_Pa", P}}));
    for (const double x : {-2e-4, -5e-5, 5e-5, 1e-4}) {
      const auto held = Hold(s, x, 1);
      const double d = held.p_bore - held.p_rod;
      const double carried = V / 2 * (std::tanh(d / P) - std::tanh(at_rest / P));
      EXPECT_NEAR(CarriedToRod(params, held, x) / carried, 1, 1e-3) << x;
      // A wall that bends, V/2P per Pa.
      if (P > 1e7) {
        EXPECT_NEAR(carried / (V / (2 * P) * (d - at_rest)), 1, 0.02) << x;
      }
    }
  }
}

// Pushed at once, it slides over with its own time.
TEST(SealShuttle, TakesItsTime) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double V = 1e-9, P = 1e5, tau = 0.2, x = -2e-4;  // so little that the pressures stay
  const PhsSystem s =
      Compile(With(params, "seal_shuttle", {{"volume_m3", V}, {"width_Pa", P}, {"slide_s", tau}}));
  const double all = CarriedToRod(params, Hold(s, x, 20 * tau, tau / 100), x);
  const double part = CarriedToRod(params, Hold(s, x, tau, tau / 1000), x);
  const double none = CarriedToRod(params, Hold(s, x, 0), x);
  EXPECT_NEAR((part - none) / (all - none), 1 - std::exp(-1.0), 2e-3);
}

// With friction P_h it stands still until d is P_h beyond, then where d - P_h would have it.
TEST(SealShuttle, ComesLooseAtItsFriction) {
  PhsParams params = Frictionless();
  for (auto& l : params.lines) l.gas_volume_m3 = 0;
  const double V = 4e-7, P = 1.5e6, P_h = 8e5,
               at_rest = params.lines[1].static_pressure_Pa - params.lines[0].static_pressure_Pa;
  const PhsSystem s = Compile(
      With(params, "seal_shuttle", {{"volume_m3", V}, {"width_Pa", P}, {"friction_Pa", P_h}}));
  const double small = -2e-5, large = -2e-4;  // d moves by 0.4 and 4 MPa
  EXPECT_NEAR(CarriedToRod(params, Hold(s, small, 1), small), 0, 1e-11);  // a trace of air
  const auto held = Hold(s, large, 1);
  const double carried =
      V / 2 * (std::tanh((held.p_bore - held.p_rod - P_h) / P) - std::tanh(at_rest / P));
  EXPECT_NEAR(CarriedToRod(params, held, large) / carried, 1, 1e-3);
}

}  // namespace
}  // namespace phs::effects
