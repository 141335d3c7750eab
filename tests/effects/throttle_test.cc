// The throttle with its relief valve: the law alone, its energy, and what it does in a steering.
#include "effects/throttle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

using hydraulics::BoBo;
using hydraulics::FlowPlace;

constexpr FlowPlace kNow = {};
constexpr ThrottleParams kBoth = {2e9, 3e13, 1.5e6, 4e8};

TEST(Throttle, IsLaminarAtSmallAndTurbulentAtLargeFlow) {
  const ThrottleFlow law({2e9, 3e13, 1e9, 4e8});
  double slope;
  EXPECT_NEAR(law.Drop(kNow, 1e-8, &slope), 2e9 * 1e-8, 1e-3 * 20);
  EXPECT_NEAR(slope, 2e9, 1e-3 * 2e9);
  const double q = 4e-3;
  EXPECT_NEAR(law.Drop(kNow, -q, &slope), -3e13 * q * q, 2e-2 * 3e13 * q * q);
}

TEST(Throttle, BeyondItsReliefPressureTheValveTakesTheRest) {
  const ThrottleFlow law(kBoth);
  double slope;
  // Without a turbulent part the sum of two straight lines.
  const ThrottleFlow laminar({2e9, 0, 1.5e6, 4e8});
  for (const double dp : {1.6e6, 3e6, -3e6}) {
    const double expected = dp / 2e9 + std::copysign((std::abs(dp) - 1.5e6) / 4e8, dp);
    EXPECT_NEAR(laminar.Flow(kNow, dp, &slope), expected, 1e-12 * std::abs(expected));
    EXPECT_NEAR(slope, 1 / 2e9 + 1 / 4e8, 1e-21);
    EXPECT_NEAR(laminar.Drop(kNow, expected, &slope), dp, 1e-9 * std::abs(dp));
  }
  // With it, both continue each other at the relief pressure.
  const double q = law.Flow(kNow, 1.5e6, &slope);
  EXPECT_NEAR(law.Flow(kNow, 1.5e6 * (1 + 1e-9), &slope), q, 1e-7 * q);
  EXPECT_LT(law.Drop(kNow, 10 * q, &slope), 1.5e6 + 4e8 * 10 * q);
  EXPECT_LE(slope, 4e8);
}

TEST(Throttle, FlowAndDropAreEachOthersInverseOddAndRising) {
  for (const ThrottleParams& p :
       {kBoth, ThrottleParams{1e3, 3e13, 1e5, 1e9}, ThrottleParams{1e12, 0, 5e5, 1e7}}) {
    const ThrottleFlow law(p);
    double before = 0, slope, back, up;
    for (double dp = 10; dp < 3e7; dp *= 1.7) {
      const double q = law.Flow(kNow, dp, &slope);
      EXPECT_GT(q, before);
      before = q;
      EXPECT_NEAR(law.Drop(kNow, q, &back), dp, 1e-9 * dp);
      EXPECT_NEAR(slope * back, 1, 1e-9);
      EXPECT_EQ(law.Flow(kNow, -dp, &slope), -q);
      EXPECT_GT(law.Flow(kNow, dp, &slope) * dp, 0) << "passive";
      const double d = 1e-5 * dp;
      if (std::abs(dp - p.relief) < 2 * d) continue;
      const double rise = (law.Flow(kNow, dp + d, &up) - law.Flow(kNow, dp - d, &up)) / (2 * d);
      EXPECT_NEAR(rise, slope, 1e-6 * slope);
    }
    EXPECT_EQ(law.Flow(kNow, 0, &slope), 0);
    EXPECT_EQ(law.Drop(kNow, 0, &slope), 0);
  }
}

// Ramp of a piston: drop of each chamber as the law says at the flow A v, but for what the oil of
// the chamber itself takes.
double RodDrop(const std::map<std::string, double>& values, double speed, double temperature_K) {
  PhsParams params = Frictionless();
  params.temperature_K = temperature_K;
  for (auto& line : params.lines) line.gas_volume_m3 = 100e-6;  // soft: the line stays behind
  const auto ramp = [speed](double t) { return speed * t; };
  return Drive(Compile(With(params, "throttle", values)), 0.3, 1e-4, ramp).p_rod -
         Drive(Compile(params), 0.3, 1e-4, ramp).p_rod;
}

TEST(Throttle, BrakesAMovingPistonByTheLaw) {
  const double area = Quarter().cylinders[0].RodArea();
  const std::map<std::string, double> laminar = {
      {"laminar_Pas_per_m3", 1e10}, {"oil_share", 0.02}, {"relief_Pa", 1e9}};
  const double drop = RodDrop(laminar, 5e-3, 293.15);
  EXPECT_NEAR(drop, 1e10 * area * 5e-3, 0.03 * drop);
  // The viscosity of VG 68 is 45 times as large at -20 °C; a sharp edge does not feel it.
  std::map<std::string, double> slow = laminar;
  slow["laminar_Pas_per_m3"] = 1e8;
  EXPECT_NEAR(RodDrop(slow, 5e-3, 253.15) / RodDrop(slow, 5e-3, 293.15), 44.7, 1.5);
  const std::map<std::string, double> sharp = {{"laminar_Pas_per_m3", 1e3},
                                               {"turbulent_Pas2_per_m6", 3e14},
                                               {"oil_share", 0.02},
                                               {"relief_Pa", 1e9}};
  const double cold = RodDrop(sharp, 5e-3, 253.15), warm = RodDrop(sharp, 5e-3, 293.15);
  EXPECT_NEAR(cold, warm, 0.01 * warm);
  // The valve holds the drop near its pressure.
  std::map<std::string, double> relieved = laminar;
  relieved["relief_Pa"] = 1e5, relieved["valve_Pas_per_m3"] = 1e7;
  EXPECT_NEAR(RodDrop(relieved, 5e-3, 293.15), 1e5, 5e3);
}

// Settled chambers: every chamber at the pressure that the line would have without throttles, no
// oil lost, nothing flows any more; a leak and the seals are left alone.
TEST(Throttle, SettledChambersHaveThePressureOfTheirLine) {
  PhsParams plain = BoBo();
  plain.lines[0].static_pressure_Pa = 2.7e6;  // out of balance, as filled on the rig
  const PhsParams throttled = With(plain, "throttle", {{"oil_share", 0.2}});
  const PhsSystem without = Compile(plain);
  const PhsSystem with = Compile(With(throttled, "external_leakage", {}, {"L2"}));
  EXPECT_FALSE(without.has_split_lines());
  ASSERT_TRUE(with.has_split_lines());
  const std::vector<double> x = {2e-3, -1e-4, 5e-4, -3e-3}, v(4, 0.0);
  std::vector<double> state(static_cast<size_t>(with.num_states()), 0.0), rate(state);
  state[0] = 1e-5;  // a bristle
  with.SettleChambers(0, x.data(), state.data());
  EXPECT_EQ(state[0], 1e-5);
  const std::vector<double> none(static_cast<size_t>(without.num_states()), 0.0);
  Evaluation a(without), b(with);
  without.Calc(0, x.data(), v.data(), none.data(), &a.out);
  with.Calc(0, x.data(), v.data(), state.data(), &b.out);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(b.pressure[i], a.pressure[i], 1e-8 * a.pressure[i]);
    EXPECT_NEAR(b.p_bore[i], a.p_bore[i], 1e-8 * a.p_bore[i]);
    EXPECT_NEAR(b.p_rod[i], a.p_rod[i], 1e-8 * a.p_rod[i]);
  }
  with.CalcStateRate(1, 0, x.data(), v.data(), state.data(), rate.data());
  int settled = 0;
  for (size_t i = 0; i < state.size(); ++i) {
    const std::string& name = with.state_names()[i];
    if (name.find("throttle") != std::string::npos) {
      EXPECT_NEAR(rate[i], 0, 1e-11) << name;
      EXPECT_GT(std::abs(state[i]), 1e-9) << name;
      ++settled;
    } else if (name.find("leak") != std::string::npos) {
      EXPECT_EQ(state[i], 0) << name;
      EXPECT_GT(rate[i], 0) << name;
    }
  }
  EXPECT_EQ(settled, 8);
}

// Opposite yaw of the axles sends oil from chamber to chamber: the throttles take all of it. What
// drives all pistons one way is borne by gas and oil as before, once it has come to rest.
TEST(Throttle, DampsBendingAndLeavesWhatIsAtRest) {
  PhsParams plain = BoBo();
  plain.friction.model = FrictionModel::kNone;
  const double R = 5e9, amplitude = 1e-3, w = 2 * M_PI;
  const PhsSystem without = Compile(plain);
  const PhsSystem with =
      Compile(With(plain, "throttle", {{"laminar_Pas_per_m3", R}, {"relief_Pa", 1e9}}));
  const double pattern[] = {1, -1, -1, 1};
  double loss[2] = {}, rest[2] = {};
  for (int k = 0; k < 2; ++k) {
    const PhsSystem& s = k == 0 ? without : with;
    std::vector<double> state(s.num_states(), 0.0), rate(state), x(4), v(4);
    Evaluation e(s);
    const double h = 1e-4;
    for (int i = 0; i < 40000; ++i) {  // three periods, then at rest
      const auto place = [&](double t) { return t < 3 ? amplitude * std::sin(w * t) : 0.0; };
      for (int c = 0; c < 4; ++c) {
        x[c] = pattern[c] * place(i * h);
        v[c] = pattern[c] * (place((i + 1) * h) - place(i * h)) / h;
      }
      s.CalcStateRate(i * h, h, x.data(), v.data(), state.data(), rate.data());
      for (size_t n = 0; n < state.size(); ++n) state[n] += h * rate[n];
      for (int c = 0; c < 4; ++c) x[c] = pattern[c] * place((i + 1) * h);
      s.Calc((i + 1) * h, x.data(), v.data(), state.data(), &e.out);
      for (int c = 0; c < 4; ++c) loss[k] += h * e.force[c] * v[c];
    }
    rest[k] = std::abs(e.force[0]);
  }
  const auto& c = plain.cylinders[0];
  const double damping = R * (c.BoreArea() * c.BoreArea() + c.RodArea() * c.RodArea());
  const double expected = 4 * 3 * M_PI * damping * w * amplitude * amplitude;
  EXPECT_NEAR(loss[0], 0, 1e-3 * expected);
  EXPECT_NEAR(loss[1], expected, 0.02 * expected);
  EXPECT_NEAR(rest[1], rest[0], 1);
}

}  // namespace
}  // namespace phs::effects
