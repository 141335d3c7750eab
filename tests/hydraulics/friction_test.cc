// Friction: true stick, no sign flicker, exact integration, passivity.
#include "hydraulics/friction.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <utility>

#include "test_systems.h"

namespace phs::hydraulics {
namespace {

TEST(Presliding, HoldsWithoutFlickerUnderSpeedNoise) {
  // A piston at rest, measured speed = white noise of 0.2 mm/s (beyond the first table point): a
  // speed look-up jumps between +-1.5 kN, the bristle does not.
  PhsParams params = Quarter();
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 2e-4);
  const double h = 1e-3;
  double spread[2];
  for (FrictionModel model : {FrictionModel::kPresliding, FrictionModel::kStatic}) {
    params.friction.model = model;
    const PhsSystem s = Make(params);
    std::vector<double> state(s.num_states(), 0.0), rate(state);
    Evaluation e(s);
    double previous = 0, position = 0, low = 1e9, high = -1e9;
    for (int i = 0; i < 20000; ++i) {
      const double shown = noise(random);  // noise on the position, differentiated
      const double v = shown - previous, x = 0;
      previous = shown;
      position += h * v;
      s.Calc(i * h, &x, &v, state.data(), &e.out);
      low = std::min(low, e.friction[0]);
      high = std::max(high, e.friction[0]);
      s.CalcStateRate(i * h, h, &x, &v, state.data(), rate.data());
      for (size_t k = 0; k < state.size(); ++k) state[k] += h * rate[k];
    }
    spread[model == FrictionModel::kStatic] = high - low;
  }
  EXPECT_LT(spread[0], 120) << "presliding";
  EXPECT_GT(spread[1], 3000) << "the look-up flickers: the test would see it";
}

TEST(Presliding, SticksUnderLoadBelowBreakawayForever) {
  // Dither of +-10 um about a deflection held below breakaway: no drift after 10^5 cycles.
  const Friction f(FrictionParams{});
  double z = 2e-5;
  for (int i = 0; i < 100000; ++i) {
    z = f.Advance(1e-3, 1e-2, z, {});
    z = f.Advance(1e-3, -1e-2, z, {});
  }
  EXPECT_NEAR(z, 2e-5, 1e-12);
}

TEST(Presliding, SlidesAtTheLevelOfTheTable) {
  const Friction f(FrictionParams{});
  for (auto [v, F] : {std::pair{0.01, 1950.0},
                      {-0.01, -1700.0},
                      {0.05, 2150.0},
                      {-0.001, -1600.0},
                      {0.0055, 1900.0},
                      {0.1, 2400.0}}) {
    const double z = f.Advance(1.0, v, 0, {});
    EXPECT_NEAR(f.Calc(v, z, {}).force, F, 1e-6) << v;
  }
}

TEST(Presliding, ExactUpdateMatchesFineIntegration) {
  const Friction f(FrictionParams{});
  for (double start : {-6e-5, -2e-5, 0.0, 3e-5, 4.6e-5, 5.3e-5}) {
    for (double v : {1e-3, -2e-3}) {
      double z = start;
      const int n = 200000;
      const double T = 0.08;
      for (int i = 0; i < n; ++i) z += T / n * f.Calc(v, z, {}).bristle_speed;
      EXPECT_NEAR(f.Advance(T, v, start, {}), z, 2e-10) << start << " " << v;
    }
  }
}

TEST(Presliding, HysteresisDissipatesAreaOfTheLoop) {
  const Friction f(FrictionParams{});
  double z = 0, work = 0, lost = 0;
  const double h = 1e-4, amplitude = 1e-3, w = 2 * M_PI * 0.5;
  const int period = 20000;
  for (int i = 0; i < 2 * period; ++i) {
    const double v = amplitude * w * std::cos(w * (i + 0.5) * h);
    const double z_mid = f.Advance(0.5 * h, v, z, {});
    const FrictionForce at = f.Calc(v, z_mid, {});
    if (i >= period) {
      work += at.force * v * h;
      lost += at.lost_power * h;
    }
    z = f.Advance(h, v, z, {});
  }
  EXPECT_NEAR(work / lost, 1, 2e-3);
  // Between the loop of the lowest and of the highest level, less the presliding corners.
  EXPECT_GT(work, 4 * amplitude * 1600 * 0.9);
  EXPECT_LT(work, 4 * amplitude * 1850);
}

/// Level times 1 + slope y, and a force more where it creeps in extension.
class Level final : public LevelLaw {
 public:
  Level(double slope, double extra) : slope_(slope), extra_(extra) {}
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->of_curve *= std::max(1 + slope_ * place.at.piston, 0.0);
    if (place.sign > 0) level->extra += extra_ * std::exp(-place.speed / 1e-3);
  }

 private:
  double slope_, extra_;
};

/// c v in retraction.
class Viscous final : public ForceLaw {
 public:
  explicit Viscous(double c) : c_(c) {}
  double Force(const ForcePlace& place) const noexcept override {
    return place.speed < 0 ? c_ * place.speed : 0;
  }

 private:
  double c_;
};

RC_GTEST_PROP(Friction, NeverGivesEnergyOverRandomMotion, ()) {
  FrictionParams p;
  p.model = *rc::gen::element(FrictionModel::kStatic, FrictionModel::kPresliding);
  p.curve = *rc::gen::element(FrictionCurve::kTable, FrictionCurve::kCoulomb);
  FrictionLaws laws;
  laws.levels.push_back(
      std::make_unique<Level>(*rc::gen::inRange(-20, 20), *rc::gen::inRange(-3000, 1000)));
  laws.forces.push_back(std::make_unique<Viscous>(*rc::gen::inRange(0, 10000)));
  const Friction f(p, std::move(laws));
  double z = 0, y = 0, work = 0;
  const double h = 1e-3;
  for (int i = 0; i < 300; ++i) {
    const double v = *rc::gen::inRange(-100, 101) * 1e-4;
    const FrictionPlace place{.piston = y};
    const FrictionForce at = f.Calc(v, z, place);
    RC_ASSERT(at.lost_power >= -1e-9);
    RC_ASSERT(std::abs(at.force * v - at.lost_power - f.stiffness() * z * at.bristle_speed) <
              1e-9 + 1e-9 * std::abs(at.lost_power));
    // Work over the step by the mean of begin and end force.
    const double z1 = f.Advance(h, v, z, place);
    work += 0.5 * (at.force + f.Calc(v, z1, place).force) * v * h;
    z = z1;
    y += h * v;
  }
  RC_ASSERT(work - f.Energy(z) > -1.0);
}

/// Adds 200 N, halves the curve, takes three quarters of all; remembers how far it went.
class Worn final : public LevelLaw {
 public:
  void Add(const LevelPlace& place, LevelParts* level) const noexcept override {
    level->extra += 200 + 10 * place.memory;
    level->of_curve *= 0.5;
    level->of_all *= 0.75;
  }
  std::string MemoryName() const override { return "wear"; }
  double MemoryRate(double v, double) const noexcept override { return std::abs(v); }
  double AdvanceMemory(double h, double v, double memory) const noexcept override {
    return memory + h * std::abs(v);
  }
};

TEST(LevelLaws, ComposeWhateverTheirOrder) {
  for (const bool worn_first : {true, false}) {
    FrictionParams p;
    FrictionLaws laws;
    if (worn_first) laws.levels.push_back(std::make_unique<Worn>());
    laws.levels.push_back(std::make_unique<Level>(20, 0));
    if (!worn_first) laws.levels.push_back(std::make_unique<Worn>());
    laws.levels.push_back(std::make_unique<Worn>());
    const Friction f(p, std::move(laws));
    const double memory[] = {3, 5};
    FrictionPlace place{.piston = 0.01, .memory = memory};
    EXPECT_NEAR(f.Level(1, 0.01, place), (1950 * 0.25 * 1.2 + 400 + 80) * 0.75 * 0.75, 1e-9);
    place.memory = nullptr;
    EXPECT_NEAR(f.Level(1, 0.01, place), (1950 * 0.25 * 1.2 + 400) * 0.75 * 0.75, 1e-9);
    place.piston = -1;  // a factor below zero would push
    EXPECT_NEAR(f.Level(1, 0.01, place), 400 * 0.75 * 0.75, 1e-9);
    EXPECT_EQ(f.num_memories(), 2);
    double after[] = {1, 1};
    f.AdvanceMemories(0.5, -4, 0, place, after);
    EXPECT_EQ(after[0], 3);
    EXPECT_EQ(after[1], 3);
  }
}

TEST(Static, IsTheLookUpOfTheTable) {
  FrictionParams p;
  p.model = FrictionModel::kStatic;
  const Friction f(p);
  for (auto [v, F] : {std::pair{0.0, 0.0},
                      {0.0001, 850.0},
                      {-0.0001, -750.0},
                      {0.0006, 1775.0},
                      {0.03, 2050.0},
                      {-0.05, -1900.0},
                      {-0.1, -2150.0}}) {
    EXPECT_NEAR(f.Calc(v, 0, {}).force, F, 1e-9) << v;
  }
}

TEST(Coulomb, StribeckAndViscousPerDirection) {
  FrictionParams p;
  p.model = FrictionModel::kStatic;
  p.curve = FrictionCurve::kCoulomb;
  p.breakaway_extension_N = 2500;
  const Friction f(p);
  EXPECT_NEAR(f.Calc(0.02, 0, {}).force, 1850 + 650 * std::exp(-20.0) + 80, 1e-9);
  EXPECT_NEAR(f.Calc(-0.02, 0, {}).force, -1600 - 80, 1e-9);
}

TEST(Presliding, NoLevelNoForce) {
  FrictionParams p;
  p.scale = 0;
  p.damping_Ns_per_m = 0;
  const Friction f(p);
  EXPECT_EQ(f.Advance(0.1, 1e-2, 0, {}), 0);
  EXPECT_EQ(f.Calc(1e-2, 0, {}).force, 0);
}

// Semi-implicit Euler with the state that belongs to x_n (phs_system.h): a mass on a stuck seal
// keeps its amplitude; without the shift it would grow.
TEST(Presliding, ShiftedStateKeepsAStuckMassPassive) {
  PhsParams params = Quarter();
  params.cylinders[0].bore_line = params.cylinders[0].rod_line = "";
  params.lines.clear();
  params.friction.damping_Ns_per_m = 0;
  const PhsSystem s = Make(params);
  double amplitude[2];
  for (bool shifted : {false, true}) {
    std::vector<double> state(1, 0.0), rate(1), used(1);
    Evaluation e(s);
    const double h = 1e-3, m = 1500;
    double x = 0, v = 1e-3, top = 0;
    for (int i = 0; i < 2000; ++i) {
      s.CalcStateRate(0, h, &x, &v, state.data(), rate.data());
      used[0] = state[0] + (shifted ? h * rate[0] : 0);
      s.Calc(0, &x, &v, used.data(), &e.out);
      state[0] += h * rate[0];
      v -= h * e.force[0] / m;
      x += h * v;
      if (i > 1900) top = std::max(top, std::abs(v));
    }
    amplitude[shifted] = top;
  }
  EXPECT_NEAR(amplitude[1], 1e-3, 1e-4);
  EXPECT_GT(amplitude[0], 2e-3);
}

}  // namespace
}  // namespace phs::hydraulics
