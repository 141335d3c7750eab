// What follows the motion is told from noise with a colour.
#include "identify/result/motion_share.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace phs::identify {
namespace {

constexpr int kMotionRows = 8000;
constexpr double kStep = 0.005;  // s

/// Slow and fast parts, reversals, rests.
std::vector<double> Motion() {
  std::vector<double> x;
  for (int i = 0; i < kMotionRows; ++i) {
    const double t = i * kStep;
    const double slow = std::sin(2 * M_PI * 0.13 * t), fast = std::sin(2 * M_PI * 1.7 * t + 1);
    x.push_back(std::fmod(t, 10) < 8 ? slow + 0.2 * fast : slow);
  }
  return x;
}

std::vector<double> Speed(const std::vector<double>& x) {
  std::vector<double> v(x.size(), 0.0);
  for (size_t i = 1; i + 1 < x.size(); ++i) v[i] = (x[i + 1] - x[i - 1]) / (2 * kStep);
  return v;
}

std::vector<double> WhiteRow(unsigned seed, double deviation) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0, deviation);
  std::vector<double> out(kMotionRows);
  for (double& y : out) y = normal(generator);
  return out;
}

/// y_i = remembered y_(i-1) + white: first-order noise of the asked deviation.
std::vector<double> ColouredRow(unsigned seed, double remembered, double deviation) {
  std::vector<double> out = WhiteRow(seed, deviation * std::sqrt(1 - remembered * remembered));
  for (size_t i = 1; i < out.size(); ++i) out[i] += remembered * out[i - 1];
  return out;
}

TEST(MotionShare, NoiseOfAnyColourDoesNotFollow) {
  const std::vector<std::vector<double>> signals = {Motion(), Speed(Motion())};
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    EXPECT_LT(MeanSquareThatFollows(WhiteRow(seed, 1), signals), 0.05) << seed;
    for (const double remembered : {0.7, 0.95}) {  // three and twenty samples
      EXPECT_LT(MeanSquareThatFollows(ColouredRow(seed, remembered, 3), signals), 9 * 0.06)
          << seed << ' ' << remembered;
    }
    std::vector<double> hum = WhiteRow(seed, 1);  // mains, 50 Hz, at its own phase
    for (size_t i = 0; i < hum.size(); ++i) {
      hum[i] += 4 * std::sin(2 * M_PI * 50.03 * kStep * static_cast<double>(i) + seed);
    }
    EXPECT_LT(MeanSquareThatFollows(hum, signals), 0.3) << seed;
  }
}

TEST(MotionShare, FrictionDampingAndCreepFollow) {
  const std::vector<double> x = Motion(), v = Speed(x);
  const std::vector<double> noise = ColouredRow(6, 0.7, 1);
  std::vector<double> friction = noise, square = noise, creep = noise;
  double remembered = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    remembered += (x[i] - remembered) * kStep / 0.3;  // s
    friction[i] += 2 * std::tanh(v[i] / 0.05), square[i] += v[i] * std::abs(v[i]);
    creep[i] += 5 * (x[i] - remembered);
  }
  for (const auto& residual : {friction, square, creep}) {
    double all = -1;  // of the noise
    for (const double r : residual) all += r * r / kMotionRows;
    const double following = MeanSquareThatFollows(residual, {x});
    EXPECT_GT(following, 0.5 * all);
    EXPECT_LT(following, 1.2 * all);
  }
}

TEST(MotionShare, AnOffsetIsNoColour) {
  std::vector<double> residual = WhiteRow(7, 1);
  for (double& r : residual) r += 2;
  EXPECT_NEAR(MeanSquareThatFollows(residual, {Motion()}), 4, 0.2);
}

/// A machine beside the rig that runs for five seconds of fourteen.
TEST(MotionShare, WhatRunsBesideTheRigComesAndGoes) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    std::vector<double> machine = WhiteRow(seed, 1), weak = machine, always = machine;
    for (size_t i = 0; i < machine.size(); ++i) {
      const double t = kStep * static_cast<double>(i), wave = std::sin(2 * M_PI * 3.1 * t);
      const bool runs = std::fmod(t + seed, 14) < 5;
      machine[i] += runs ? 20 * wave : 0, weak[i] += runs ? 4 * wave : 0, always[i] += 20 * wave;
    }
    EXPECT_LT(MeanSquareThatFollows(machine, {Motion()}), 0.05 * 67) << seed;
    EXPECT_TRUE(ComesAndGoes(machine)) << seed;
    EXPECT_FALSE(ComesAndGoes(weak)) << "chance makes colours as uneven";
    EXPECT_FALSE(ComesAndGoes(always)) << seed;
    EXPECT_FALSE(ComesAndGoes(WhiteRow(seed, 1))) << seed;
    for (const double remembered : {0.7, 0.95, 0.995}) {  // to one second
      EXPECT_FALSE(ComesAndGoes(ColouredRow(seed, remembered, 20))) << remembered;
    }
  }
}

/// A seal squeals while the rig moves, whatever its speed: no function of the motion, and in every part
/// of the window; at rest, for a second in seven, it is silent. A sensor's noise is not.
TEST(MotionShare, WhatIsSilentAtRestIsNoNoiseOfTheSensor) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    std::vector<double> squeal = WhiteRow(seed, 1), weak = squeal;
    std::vector<char> still;
    for (size_t i = 0; i < squeal.size(); ++i) {
      const double t = kStep * static_cast<double>(i), wave = std::sin(2 * M_PI * 17.3 * t);
      still.push_back(std::fmod(t + seed, 7) < 1);
      squeal[i] += still[i] ? 0 : 10 * wave, weak[i] += still[i] ? 0 : 0.8 * wave;
    }
    EXPECT_FALSE(ComesAndGoes(squeal)) << seed;
    EXPECT_TRUE(IsQuietAtRest(squeal, still)) << seed;
    EXPECT_FALSE(IsQuietAtRest(weak, still)) << seed;
    EXPECT_FALSE(IsQuietAtRest(WhiteRow(seed, 1), still)) << seed;
    EXPECT_FALSE(IsQuietAtRest(squeal, std::vector<char>(squeal.size(), 0))) << "never at rest";
    for (const double remembered : {0.7, 0.95, 0.995}) {
      EXPECT_FALSE(IsQuietAtRest(ColouredRow(seed, remembered, 20), still)) << remembered;
    }
  }
}

/// A loose plug: to and fro after stays of a third of a second on average, nine noises apart.
TEST(MotionShare, ALoosePlugStandsOnTwoLevels) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    std::mt19937 generator(seed + 100);
    std::exponential_distribution<double> stay(3);  // 1/s
    std::vector<double> plug = WhiteRow(seed, 1), weak = plug, sine = plug, ramp = plug;
    double next = stay(generator);
    bool up = false;
    int jumps = 0;
    for (size_t i = 0; i < plug.size(); ++i) {
      const double t = kStep * static_cast<double>(i);
      for (; t > next; next += stay(generator)) up = !up, ++jumps;
      plug[i] += up ? 9 : 0, weak[i] += up ? 4 : 0;
      sine[i] += 20 * std::sin(2 * M_PI * 0.4 * t), ramp[i] += 20 * std::fmod(t, 3);
    }
    const auto found = FindTwoLevels(plug);
    ASSERT_TRUE(found) << seed;
    EXPECT_NEAR(found->apart, 9, 0.1) << seed;
    EXPECT_NEAR(found->jumps, jumps, 0.1 * jumps) << "some stays are shorter than a sample";
    EXPECT_FALSE(FindTwoLevels(weak)) << "a sample does not tell where it is";
    EXPECT_FALSE(FindTwoLevels(sine)) << "it lingers at both ends, and passes what lies between";
    EXPECT_FALSE(FindTwoLevels(ramp)) << seed;
    EXPECT_FALSE(FindTwoLevels(WhiteRow(seed, 1))) << seed;
    EXPECT_FALSE(FindTwoLevels(ColouredRow(seed, 0.995, 20))) << seed;
    std::vector<double> hum = WhiteRow(seed, 1);  // at half the rate: up and down with each sample
    for (size_t i = 0; i < hum.size(); ++i) hum[i] += i % 2 ? 9 : -9;
    EXPECT_FALSE(FindTwoLevels(hum)) << seed;
  }
}

/// A press next door strikes every 1.3 s, and the frame rings for a seventh of a second: in every part.
TEST(MotionShare, BlowsAreNoNoiseOfTheSensor) {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u}) {
    std::vector<double> press = WhiteRow(seed, 1);
    for (size_t i = 0; i < press.size(); ++i) {
      const double since = std::fmod(kStep * static_cast<double>(i) + 0.2 * seed, 1.3);
      press[i] += 50 * std::exp(-since / 0.14) * std::cos(2 * M_PI * 13 * since);
    }
    EXPECT_LT(MeanSquareThatFollows(press, {Motion()}), 4) << seed;
    EXPECT_TRUE(ComesAndGoes(press)) << seed;
  }
}

/// A pump in bursts, and a seal that squeals a tenth lower on the way back.
TEST(MotionShare, WhatSwingsHasItsFrequency) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::vector<double> pump = WhiteRow(seed, 1), squeal = pump, driven = pump;
    for (size_t i = 0; i < pump.size(); ++i) {
      const double t = kStep * static_cast<double>(i);
      if (std::fmod(t, 9) < 5) pump[i] += 4 * std::sin(2 * M_PI * 13.25 * t + seed);
      const double pitch = std::fmod(t, 4) < 2 ? 30 : 27;
      if (std::fmod(t, 2) < 0.7) squeal[i] += 4 * std::sin(2 * M_PI * pitch * t);
      driven[i] += 4 * std::sin(2 * M_PI * 6.3 * t);
    }
    EXPECT_NEAR(SwingsAt(pump, {Speed(Motion())}) / kStep, 13.25, 0.1) << seed;
    EXPECT_NEAR(SwingsAt(squeal, {Speed(Motion())}) / kStep, 28.5, 1) << seed;
    std::vector<double> shaken = Speed(Motion());
    for (size_t i = 0; i < shaken.size(); ++i) {
      shaken[i] += 10 * std::cos(2 * M_PI * 6.3 * kStep * static_cast<double>(i));
    }
    EXPECT_EQ(SwingsAt(driven, {shaken}), 0) << "the rig is moved so";
    EXPECT_EQ(SwingsAt(WhiteRow(seed, 1), {Speed(Motion())}), 0) << seed;
    EXPECT_EQ(SwingsAt(ColouredRow(seed, 0.95, 5), {Speed(Motion())}), 0) << seed;
  }
}

TEST(MotionShare, GapsAndShortRecords) {
  std::vector<double> residual = ColouredRow(8, 0.7, 3);
  for (size_t i = 100; i < 500; ++i) residual[i] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_LT(MeanSquareThatFollows(residual, {Motion()}), 0.5);
  // What cannot be told counts whole: it is not taken for noise.
  EXPECT_DOUBLE_EQ(MeanSquareThatFollows({1, 2, 3}, {{1, 2, 3}}), 14.0 / 3);
  std::vector<double> broken = Motion();
  broken[7] = std::numeric_limits<double>::quiet_NaN();
  for (const std::vector<double>& signal : {std::vector<double>{1, 2, 3}, broken}) {
    EXPECT_GT(MeanSquareThatFollows(residual, {signal}), 7);
  }
  EXPECT_GT(MeanSquareThatFollows(residual, {}), 7);
}

}  // namespace
}  // namespace phs::identify
