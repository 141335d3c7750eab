// A converter with a stuck bit, made as a converter works: floor to the bit's weight, bit by bit.
#include "measurement/stuck_bit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace phs::measurement {
namespace {

constexpr double kStep_s = 0.005, kSensorNoise = 4e3, kWeight = 1.1e5;  // s, Pa, Pa
constexpr int kSamples = 8000;

/// A pressure that swings, slowly and fast, ramps and holds.
std::vector<double> TruePressure() {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, kSensorNoise);
  std::vector<double> p;
  for (int i = 0; i < kSamples; ++i) {
    const double t = i * kStep_s, ramp = std::clamp(std::sin(2 * M_PI * 0.05 * t) * 2, -1.0, 1.0);
    p.push_back(6e6 + 1.5e6 * ramp + 1e6 * std::sin(2 * M_PI * 0.31 * t) + normal(random));
  }
  return p;
}

/// The bit of weight kWeight at the value `bit` from sample `from` on; noise of 1 kPa behind it.
std::vector<double> Stuck(std::vector<double> p, int bit, int from) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal(0, 1e3);
  for (int i = 0; i < kSamples; ++i) {
    double& y = p[static_cast<size_t>(i)];
    const int own = static_cast<int>(std::floor((y + 3.7e4) / kWeight)) & 1;
    if (i >= from) y += (bit - own) * kWeight;
    y += normal(random);
  }
  return p;
}

class StuckBitAt : public testing::TestWithParam<int> {};

TEST_P(StuckBitAt, IsFoundAndReadBack) {
  const int bit = GetParam(), from = 1300;
  const std::vector<double> p = TruePressure(), y = Stuck(p, bit, from);
  const auto found = FindStuckBit(y);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->weight, kWeight, 0.002 * kWeight);
  EXPECT_EQ(found->at_one, bit == 1);
  EXPECT_LE(found->from, static_cast<size_t>(from));
  EXPECT_GT(found->from, static_cast<size_t>(from - 200)) << "the last time it kept to no band";
  int wrong = 0, untold = 0;
  for (size_t i = 0; i < y.size(); ++i) {
    const double shift = found->at_one ? found->weight : -found->weight;
    const double back = found->wrong[i] != 0 ? y[i] - shift : y[i];
    untold += found->told[i] == 0;
    wrong += found->told[i] != 0 && std::abs(back - p[i]) > 0.5 * kWeight;
  }
  EXPECT_LT(wrong, kSamples / 200);
  EXPECT_LT(untold, kSamples / 20);
}

INSTANTIATE_TEST_SUITE_P(Zero, StuckBitAt, testing::Values(0));
INSTANTIATE_TEST_SUITE_P(One, StuckBitAt, testing::Values(1));

TEST(StuckBit, ASoundChannelHasNone) {
  EXPECT_FALSE(FindStuckBit(TruePressure()).has_value());
  EXPECT_FALSE(FindStuckBit(std::vector<double>(kSamples, 2e6)).has_value());
}

// A load cell on a piston that turns: jumps of twice the friction, all alike, on a flat channel; also
// without noise, as a program writes it.
TEST(StuckBit, FrictionThatTurnsIsNone) {
  for (const double noise : {20.0, 1e-9}) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, noise);
    std::vector<double> force;
    for (int i = 0; i < kSamples; ++i) {
      const double angle = 2 * M_PI * 0.7 * i * kStep_s;
      force.push_back((std::cos(angle) > 0 ? 1600 : -1600) + 200 * std::sin(angle) +
                      normal(random));
    }
    EXPECT_FALSE(FindStuckBit(force).has_value()) << noise;
  }
}

// Coarse steps of a sound converter: all its values are multiples of one.
TEST(StuckBit, CoarseStepsAreNone) {
  std::vector<double> p = TruePressure();
  for (double& y : p) y = std::floor(y / 1e5) * 1e5;
  EXPECT_FALSE(FindStuckBit(p).has_value());
}

TEST(StuckBit, IsReadBackInTheChannelAndSaid) {
  RigRun run;
  run.step_s = kStep_s;
  Channel channel;
  channel.name = "p_rod_Pa", channel.y = Stuck(TruePressure(), 1, 1300);
  channel.bad.assign(channel.y.size(), 0);
  std::vector<DataFinding> findings;
  ReadBackStuckBit(run, &channel, &findings);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].text, testing::HasSubstr("is stuck at 1 from 6."));
  const std::vector<double> p = TruePressure();
  double square = 0;
  for (size_t i = 0; i < p.size(); ++i) {
    if (channel.bad[i] == 0) square += (channel.y[i] - p[i]) * (channel.y[i] - p[i]);
  }
  EXPECT_LT(std::sqrt(square / kSamples), 0.1 * kWeight) << "a stuck bit is off by 0.7 weights";
}

}  // namespace
}  // namespace phs::measurement
