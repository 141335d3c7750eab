// Harmonic balance against closed forms and published numbers.
#include "analysis/harmonic_balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/balance_branch.h"
#include "analysis/hunting_map.h"
#include "analysis/stability.h"
#include "hydraulics/bristle.h"
#include "vehicle/simulation.h"

namespace phs::analysis {
namespace {

using Eigen::VectorXd;
using std::numbers::pi;

/// One mass: x'' = a(x, x', z; p), z' = r.
template <typename Rates>
VibratingSystem OneMass(int states, Rates rates) {
  return {1, states, VectorXd::Constant(2 + states, 1e-6), 1e-6, VectorXd::Ones(1), rates};
}

PeriodicMotion Sine(double amplitude, int states, int harmonics, double parameter) {
  PeriodicMotion m;
  m.coefficients = Eigen::MatrixXd::Zero(1 + states, 2 * harmonics + 1);
  m.coefficients(0, 1) = amplitude;
  m.omega = 1;
  m.parameter = parameter;
  return m;
}

VectorXd Pair(double a, double b) { return VectorXd{{a, b}}; }

TEST(HarmonicBalanceTest, VanDerPolByOneHarmonicIsItsDescribingFunction) {
  // x'' = (p - x²) x' - x: p = A²/4, omega = 1.
  const auto system = OneMass(0, [](double p, const VectorXd& x) {
    return VectorXd::Constant(1, (p - x[0] * x[0]) * x[1] - x[0]);
  });
  for (const double amplitude : {0.5, 1.0, 3.0}) {
    const auto found = SolveBalance(system, Sine(amplitude, 0, 1, 0.5), amplitude);
    ASSERT_TRUE(found.ok()) << found.error().Line();
    EXPECT_NEAR(found.value().parameter, amplitude * amplitude / 4, 1e-6);
    EXPECT_NEAR(found.value().omega, 1, 1e-6);
  }
}

TEST(HarmonicBalanceTest, VanDerPolByManyHarmonicsHasThePublishedPeriod) {
  // x'' = (p - x²) x' - x at p = 1: period 6.6632868593, largest x 2.0086198609 (M. S. Andersen,
  // J. F. Geer, J. Appl. Math. 42 (1982) 678 and others).
  const auto system = OneMass(0, [](double p, const VectorXd& x) {
    return VectorXd::Constant(1, (p - x[0] * x[0]) * x[1] - x[0]);
  });
  // Which first harmonic belongs to p = 1 is found by the secant method.
  double a[2] = {1.99, 2.01}, p[2] = {0, 0};
  PeriodicMotion motion = Sine(2, 0, 15, 1);
  for (int i = 0; i < 12 && std::abs(p[1] - 1) > 1e-9; ++i) {
    const int k = i < 2 ? i : 1;
    if (i >= 2) {
      const double next = a[1] + (1 - p[1]) * (a[1] - a[0]) / (p[1] - p[0]);
      a[0] = a[1], p[0] = p[1], a[1] = next;
    }
    const auto found = SolveBalance(system, motion, a[k], {.samples = 128});
    ASSERT_TRUE(found.ok()) << found.error().Line();
    motion = found.value();
    p[k] = motion.parameter;
  }
  EXPECT_NEAR(p[1], 1, 1e-8);
  EXPECT_NEAR(2 * pi / motion.omega, 6.6632868593, 1e-6);
  double largest = 0;
  for (int i = 0; i < 10000; ++i) largest = std::max(largest, motion.At(2 * pi * i / 1e4, 1)[0]);
  EXPECT_NEAR(largest, 2.0086198609, 2e-5);
}

/// x'' = (g(p) - x²) x' - x with g = 1 - (p - 2)²: one harmonic has A² = 4 g(p), largest at p = 2.
VibratingSystem Arch() {
  return OneMass(0, [](double p, const VectorXd& x) {
    return VectorXd::Constant(1, (1 - (p - 2) * (p - 2) - x[0] * x[0]) * x[1] - x[0]);
  });
}

TEST(HarmonicBalanceTest, OnALineOfOneParameterTheAmplitudeIsFound) {
  const auto system = Arch();
  for (const double p : {1.2, 2.0, 2.7}) {
    const auto found = SolveBalance(system, Sine(1, 0, 1, p), BalanceLine{0, 1, p});
    ASSERT_TRUE(found.ok()) << found.error().Line();
    EXPECT_NEAR(found.value().Amplitude(system.watched, 1), 2 * std::sqrt(1 - (p - 2) * (p - 2)),
                1e-6);
  }
}

TEST(BalanceBranchTest, GoesOverTheTopWhereTheAmplitudeFallsAgain) {
  const auto system = Arch();
  const auto of = [&](double p) {
    return SolveBalance(system, Sine(1, 0, 1, p), {0, 1, p}).value();
  };
  BalanceBranch branch(system, {.step = 0.2, .largest = 5}, of(1.1), of(1.12));
  double largest = 0, last = 1.12;
  while (branch.last().parameter < 2.9) {
    ASSERT_TRUE(branch.Next()) << branch.last().parameter;
    const double p = branch.last().parameter, a = branch.last().Amplitude(system.watched, 1);
    EXPECT_GT(p, last);
    EXPECT_NEAR(a * a, 4 * (1 - (p - 2) * (p - 2)), 1e-6);
    last = p, largest = std::max(largest, a);
  }
  EXPECT_NEAR(largest, 2, 0.01);
}

TEST(BalanceBranchTest, IsCutAtTheLargestAmplitude) {
  const auto system = Arch();
  const auto of = [&](double p) {
    return SolveBalance(system, Sine(1, 0, 1, p), {0, 1, p}).value();
  };
  BalanceBranch branch(system, {.step = 0.2, .largest = 1.5}, of(1.1), of(1.12));
  while (branch.Next()) {
  }
  EXPECT_NEAR(branch.last().Amplitude(system.watched, 1), 1.5, 1e-6);
  EXPECT_NEAR(branch.last().parameter, 2 - std::sqrt(1 - 1.5 * 1.5 / 4), 1e-6);
}

TEST(HarmonicBalanceTest, CoulombFrictionTakesFourFOverPiA) {
  // x'' = p x' - F sgn x' - x, one harmonic: p = 4F/(pi A omega).
  constexpr double kForce = 0.02;
  const auto system = OneMass(0, [](double p, const VectorXd& x) {
    return VectorXd::Constant(1, p * x[1] - kForce * std::tanh(x[1] / 1e-3) - x[0]);
  });
  for (const double amplitude : {0.5, 1.0, 2.0}) {
    const auto found =
        SolveBalance(system, Sine(amplitude, 0, 1, 0.03), amplitude, {.samples = 512});
    ASSERT_TRUE(found.ok()) << found.error().Line();
    EXPECT_NEAR(found.value().parameter * pi * amplitude / (4 * kForce), 1, 2e-3);
    EXPECT_NEAR(found.value().omega, 1, 1e-6);
  }
}

TEST(HarmonicBalanceTest, AStickingSealIsAStiffnessAndALossThatHasAMaximum) {
  // A seal that sticks up to X = F/k and then slides (a Jenkins element): the loss of a cycle is
  // 4 F (A - X), the stiffness k/pi (theta - sin 2 theta/2), cos theta = 1 - 2X/A (T. K. Caughey,
  // J. Appl. Mech. 27 (1960) 640). Small beside the spring, so that the motion is a sine.
  constexpr double kStiff = 2e-3, kX = 0.4;
  const hydraulics::ElastoPlastic bristle{0.99};
  const auto system = OneMass(1, [&](double p, const VectorXd& x) {
    const double z = x[2], v = x[1];
    const double along = v >= 0 ? z : -z;
    return Pair(p * v - kStiff * z - x[0], v * (1 - bristle.Yield(along, kX)));
  });
  for (const double amplitude : {0.6, 0.8, 2.0}) {
    PeriodicMotion start = Sine(amplitude, 1, 25, 1e-4);
    start.coefficients(1, 1) = kX;
    const auto found = SolveBalance(system, start, amplitude, {.samples = 256, .iterations = 100});
    ASSERT_TRUE(found.ok()) << found.error().Line();
    const PeriodicMotion& m = found.value();
    const double theta = std::acos(1 - 2 * kX / amplitude);
    const double stiffness = kStiff / pi * (theta - std::sin(2 * theta) / 2);
    const double loss = 4 * kStiff * kX * (amplitude - kX);
    EXPECT_NEAR(m.parameter * pi * amplitude * amplitude * m.omega / loss, 1, 0.02) << amplitude;
    EXPECT_NEAR((m.omega * m.omega - 1) / stiffness, 1, 0.02) << amplitude;
  }
}

Result<vehicle::Simulation> Cooperrider() {
  vehicle::Scenario s;
  s.track = "straight";
  s.bogie = "cooperrider";
  s.speed_m_s = 60;
  s.timestep_s = 1e-4;
  return vehicle::Simulation::Create(s);
}

TEST(HuntingMapTest, ASmallMotionOfTheCooperriderBogieIsItsLinearMode) {
  auto simulation = Cooperrider();
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  const auto linear = AnalyseStability(&simulation.value(), {50, 90, 9});
  ASSERT_TRUE(linear.ok());
  HuntingMapOptions options{.harmonics = 2, .samples = 16, .least_m = 1e-5, .largest_m = 1.1e-5};
  const auto map = FindHuntingMap(&simulation.value(), linear.value().mode, options);
  ASSERT_TRUE(map.ok()) << map.error().Line();
  EXPECT_NEAR(map.value().front().speed / linear.value().critical_speed, 1, 1e-4);
  const double omega = std::abs(linear.value().mode.eigenvalue.imag());
  EXPECT_NEAR(2 * pi * map.value().front().frequency / omega, 1, 1e-4);
}

TEST(HuntingMapTest, TheCooperriderMapHasItsLeastSpeedWhereHuntingDiesInTime) {
  // In time hunting dies at 67.1 m/s (docs/stability.md): a run that is let go near the least speed
  // of the map easily falls below the brink, so time says rather too much.
  auto simulation = Cooperrider();
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  const auto linear = AnalyseStability(&simulation.value(), {50, 90, 9});
  ASSERT_TRUE(linear.ok());
  const HuntingMapOptions options{
      .harmonics = 3, .samples = 64, .least_m = 1e-3, .largest_m = 11e-3};
  const auto map = FindHuntingMap(&simulation.value(), linear.value().mode, options);
  ASSERT_TRUE(map.ok()) << map.error().Line();
  const HuntingPoint* least = LeastSpeed(map.value());
  ASSERT_NE(least, nullptr);
  EXPECT_LT(least->speed, 67.1);
  EXPECT_GT(least->speed, 66.4);
  EXPECT_GT(least->amplitude, 8.5e-3);
}

TEST(HuntingMapTest, BrinkAndHuntingAreReadOffTheMap) {
  const auto at = [](double amplitude, double speed) {
    HuntingPoint p;
    p.amplitude = amplitude;
    p.speed = speed;
    return p;
  };
  const std::vector<HuntingPoint> map = {at(1e-3, 100), at(2e-3, 80), at(3e-3, 60), at(4e-3, 90)};
  EXPECT_NEAR(HuntingAtSpeed(map, 70).brink, 2.5e-3, 1e-12);
  EXPECT_NEAR(HuntingAtSpeed(map, 70).cycle, 3e-3 + 1e-3 / 3, 1e-12);
  EXPECT_TRUE(std::isnan(HuntingAtSpeed(map, 95).cycle)) << "beyond the last point";
  EXPECT_TRUE(std::isnan(HuntingAtSpeed(map, 50).brink));
  ASSERT_NE(LeastSpeed(map), nullptr);
  EXPECT_EQ(LeastSpeed(map)->amplitude, 3e-3);
  EXPECT_EQ(LeastSpeed({map[0], map[1]}), nullptr) << "still falling at its end";
}

TEST(HuntingMapTest, TooFewSamplesAreRefused) {
  auto simulation = Cooperrider();
  ASSERT_TRUE(simulation.ok()) << simulation.error().Line();
  const auto map = FindHuntingMap(&simulation.value(), {}, {.harmonics = 5, .samples = 20});
  ASSERT_FALSE(map.ok());
  EXPECT_EQ(map.error().Line().find("samples of the map of hunting"), 0u) << map.error().Line();
}

}  // namespace
}  // namespace phs::analysis
