// A wall of a line that snaps over: at which pressures, by how much, what it loses.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

constexpr double kVolume = 3e-7, kCentre = 4e6, kHalf = 8e5;

/// Oil alone in the lines, the wall on the rod line; a width of 10 kPa makes it snap.
PhsParams WithWall(double volume, double centre) {
  PhsParams params = OilWith("snap_through", {{"volume_m3", volume},
                                              {"centre_Pa", centre},
                                              {"snap_Pa", kHalf},
                                              {"width_Pa", 1e4},
                                              {"time_s", 2e-3}});
  params.effects.back().targets = {"L1"};
  return params;
}

/// What the wall has taken from the rod line beyond the static state: V_oil (p - p0)/beta = A_rod x
/// - taken.
double Taken(const PhsParams& params, const Held& at, double x) {
  const auto& rod = params.lines[0];
  return params.cylinders[0].RodArea() * x -
         rod.oil_volume_m3 * (at.p_rod - rod.static_pressure_Pa) / rod.bulk_modulus_Pa;
}

/// Pressure of the rod line that its oil alone would have.
double OfOilAlone(const PhsParams& params, double taken, double x) {
  const auto& rod = params.lines[0];
  return rod.static_pressure_Pa +
         rod.bulk_modulus_Pa / rod.oil_volume_m3 * (params.cylinders[0].RodArea() * x - taken);
}

// Slowly out and back over half a sine; each position is passed twice. It is out from where the oil
// alone would pass p_c + P_s until, with V in the wall, it falls below p_c - P_s.
TEST(SnapThrough, GoesOutAboveOnePressureAndBackBelowAnother) {
  const PhsParams params = WithWall(kVolume, kCentre);
  const PhsSystem s = Compile(params);
  const double period = 10;
  const auto motion = [&](double t) { return 5e-4 * std::sin(M_PI * t / period); };
  int seen_out = 0;
  for (const double share : {0.05, 0.15, 0.22, 0.3, 0.5, 0.7, 0.8, 0.85, 0.93, 0.97}) {
    const double t = share * period, x = motion(t);
    const bool out = share < 0.5 ? OfOilAlone(params, 0, x) > kCentre + kHalf
                                 : OfOilAlone(params, kVolume, x) > kCentre - kHalf;
    seen_out += out ? 1 : 0;
    EXPECT_NEAR(Taken(params, Drive(s, t, 1e-4, motion), x), out ? kVolume : 0, 0.01 * kVolume)
        << share;
  }
  EXPECT_EQ(seen_out, 6);
}

// Out and back loses 2 P_s V: so little that the pressure stays while it snaps.
TEST(SnapThrough, LosesTwiceItsHalfTimesItsVolume) {
  const PhsParams params = WithWall(1e-9, kCentre);
  const PhsSystem s = Compile(params);
  const double h = 2e-5, period = 4;
  const auto motion = [&](double t) { return 2.5e-4 * (1 - std::cos(2 * M_PI * t / period)); };
  std::vector<double> state(s.num_states(), 0.0), rate(state);
  Evaluation e(s);
  double lost = 0;
  for (int i = 0; i < static_cast<int>(period / h); ++i) {
    const double x = motion(i * h), v = (motion((i + 1) * h) - x) / h;
    s.Calc(i * h, &x, &v, state.data(), &e.out);
    lost += h * e.out.lost_power;
    s.CalcStateRate(i * h, h, &x, &v, state.data(), rate.data());
    for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
  }
  EXPECT_NEAR(lost / (2 * kHalf * 1e-9), 1, 0.03);
}

// Static 2 MPa, p_c 1.2 MPa: it stands out at first and gives V back below 0.4 MPa.
TEST(SnapThrough, StandsOutWhereTheStaticPressureHoldsIt) {
  const PhsParams params = WithWall(kVolume, 1.2e6);
  const PhsSystem s = Compile(params);
  EXPECT_NEAR(Taken(params, Hold(s, 1e-4, 1), 1e-4), 0, 0.01 * kVolume);
  EXPECT_NEAR(Taken(params, Hold(s, -1e-4, 1), -1e-4), 0, 0.01 * kVolume);
  EXPECT_NEAR(Taken(params, Hold(s, -2e-4, 1), -2e-4), -kVolume, 0.01 * kVolume);
}

}  // namespace
}  // namespace phs::effects
