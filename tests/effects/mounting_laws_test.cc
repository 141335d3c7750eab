// The law of every mounting effect, on its own: closed formulas at a few points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

TEST(Backlash, PistonStaysWhileThePlayIsCrossed) {
  const double gap = 4e-4;
  const PhsSystem s = Compile(With(Quarter(), "backlash", {{"gap_m", gap}}));
  const Held inside = Drive(s, 1, 1e-3, [](double t) { return 1.5e-4 * t; });
  EXPECT_NEAR(inside.force, 0, 1e-6);
  EXPECT_NEAR(inside.piston, 0, 2e-6) << "held by friction";
  const Held beyond = Drive(s, 1, 1e-3, [](double t) { return 2e-3 * t; });
  EXPECT_NEAR(beyond.piston, 2e-3 - gap / 2 - beyond.force / 1e9, 1e-9);
}

TEST(Backlash, MayRestNearOneEndOfItsPlay) {
  const double gap = 4e-4, share = 0.2, k = 1e9, b = 1e9;
  const PhsSystem s = Compile(With(Quarter(), "backlash",
                                   {{"gap_m", gap},
                                    {"contact_N_per_m", k},
                                    {"tension_share", share},
                                    {"hardening_1_per_m2", b}}));
  for (const double x : {2e-3, -2e-3}) {
    const Held beyond = Drive(s, 1, 1e-3, [x](double t) { return x * t; });
    const double e = x - beyond.piston - (x > 0 ? share * gap : -(1 - share) * gap);
    EXPECT_NEAR(beyond.force, k * e * (1 + b * e * e), 1e-3 * std::abs(beyond.force));
    EXPECT_GT(std::abs(beyond.force), 5e3);
  }
}

TEST(MountCompliance, DeflectsByForceOverStiffness) {
  const double k = 4.1e7;
  const PhsSystem s = Compile(With(Quarter(), "mount_compliance", {{"stiffness_N_per_m", k}}));
  for (double x : {3e-3, -2e-3}) {
    const Held h = Drive(s, 1, 1e-3, [x](double t) { return x * t; });
    EXPECT_NEAR(x - h.piston, h.force / k, 1e-12);
    EXPECT_NEAR(h.force - h.pressure_force - h.friction, 0, 1e-6);
    EXPECT_NEAR(h.friction,
                x > 0 ? 1850 + 100 * (x - 1e-3) / 9e-3 : -1600 - 100 * (2e-3 - 1e-3) / 9e-3, 30);
  }
}

TEST(BushViscoelastic, RelaxesWithItsTime) {
  // Against a cylinder much stiffer than the bush (no gas): F = (k + k2 exp(-t/tau)) x.
  PhsParams p = Frictionless();
  for (auto& l : p.lines) l.gas_volume_m3 = 0, l.oil_volume_m3 = 1e-7;
  const double k = 1e7, k2 = 5e6, tau = 0.2, x = 1e-5;
  const PhsSystem s =
      Compile(With(p, "bush_viscoelastic",
                   {{"stiffness_N_per_m", k}, {"relaxing_N_per_m", k2}, {"relaxation_s", tau}}));
  const double h = 1e-4;
  const auto step = [x, h](double t) { return t >= h ? x : 0; };
  const Held soon = Drive(s, 2 * h, h, step), later = Drive(s, tau + h, h, step);
  const Held end = Drive(s, 20 * tau, h, step);
  const double F0 = end.force;
  EXPECT_NEAR((soon.force - F0) / ((k2 * x)), 1, 0.02);
  EXPECT_NEAR((later.force - F0) / (soon.force - F0), std::exp(-1), 0.01);
}

// Plays add, springs stand in series whatever their order, and the one that stiffens most counts.
TEST(Mountings, SeveralComposeAsASeries) {
  const double gap = 2e-4, contact = 2e8, k = 5e7, b = 4e6;
  for (const bool play_first : {true, false}) {
    PhsParams p = Quarter();
    const auto add_play = [&] {
      p = With(p, "backlash",
               {{"gap_m", gap}, {"contact_N_per_m", contact}, {"tension_share", 0.2}});
    };
    if (play_first) add_play();
    p = With(p, "mount_compliance", {{"stiffness_N_per_m", k}, {"hardening_1_per_m2", b}});
    if (!play_first) add_play();
    const PhsSystem s = Compile(p);
    const double together = 1 / (1 / contact + 1 / k);
    for (const double x : {3e-3, -3e-3}) {
      const Held h = Drive(s, 1, 1e-3, [x](double t) { return x * t; });
      const double e = x - h.piston - (x > 0 ? 0.2 * gap : -0.8 * gap);
      EXPECT_NEAR(h.force, together * e * (1 + b * e * e), 1e-9 * std::abs(h.force));
      EXPECT_GT(std::abs(h.force), 5e3);
    }
  }
}

TEST(Mountings, TwoBushesKeepTheirStatesApart) {
  const std::map<std::string, double> slow = {{"relaxation_s", 3}}, fast = {{"relaxation_s", 0.03}};
  const PhsSystem s =
      Compile(With(With(Quarter(), "bush_viscoelastic", slow), "bush_viscoelastic", fast));
  const auto& names = s.state_names();
  for (const char* name : {"1.bush", "1.bush_2"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  const Held h = Drive(s, 0.3, 1e-3, [](double t) { return 3e-3 * t; });
  const size_t bush = std::find(names.begin(), names.end(), "1.bush") - names.begin();
  EXPECT_GT(h.state[bush + 1], 2 * h.state[bush]) << "the slow one follows the deflection later";
}

}  // namespace
}  // namespace phs::effects
