// The smoothed motion against the motion that was measured with noise.
#include "measurement/motion_smoother.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace phs::identify {

using measurement::SmoothMotion;
using measurement::SmoothPosition;
namespace {

constexpr double kStep = 0.005, kNoise = 6e-7;
constexpr int kSamples = 3000;

using Motion = std::function<double(double)>;

std::vector<double> Measure(const Motion& motion, int seed = 5) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::normal_distribution<double> normal;
  std::vector<double> out;
  out.reserve(kSamples);
  for (int i = 0; i < kSamples; ++i) out.push_back(motion(i * kStep) + kNoise * normal(random));
  return out;
}

SmoothMotion Smoothed(const Motion& motion) {
  return SmoothPosition(Measure(motion), {}, kStep, kNoise);
}

/// Rms over the samples but for the first and the last half second.
double Rms(const std::function<double(int)>& error) {
  double sum = 0;
  for (int i = 100; i < kSamples - 100; ++i) sum += std::pow(error(i), 2);
  return std::sqrt(sum / (kSamples - 200));
}

double PositionError(const SmoothMotion& smooth, const Motion& motion) {
  return Rms([&](int i) { return smooth.position[i] - motion(i * kStep); });
}

double SpeedError(const SmoothMotion& smooth, const Motion& motion) {
  return Rms([&](int i) {
    const double t = i * kStep, d = 1e-5;
    return smooth.speed[i] - (motion(t + d) - motion(t - d)) / (2 * d);
  });
}

double Sine(double amplitude, double frequency_Hz, double t) {
  return amplitude * std::sin(2 * M_PI * frequency_Hz * t);
}

// White jerk alone takes 1 mm at 8 Hz for a motion that may turn within a sample: 0.93 of the noise
// in position and 1.5e-4 m/s.
TEST(MotionSmootherTest, ASmoothMotionKeepsLittleOfTheNoise) {
  const Motion quick = [](double t) { return Sine(1e-3, 8, t); };
  const SmoothMotion smooth = Smoothed(quick);
  EXPECT_LT(PositionError(smooth, quick), 0.6 * kNoise);
  EXPECT_LT(SpeedError(smooth, quick), 5e-5);
  const Motion slow = [](double t) { return Sine(2e-3, 0.5, t); };
  EXPECT_LT(PositionError(Smoothed(slow), slow), 0.25 * kNoise);
  EXPECT_LT(SpeedError(Smoothed(slow), slow), 3e-6);
}

// What a line that rings at 48 Hz would hear.
TEST(MotionSmootherTest, NoNoiseIsLeftFarAboveWhatMoves) {
  const SmoothMotion smooth = Smoothed([](double t) { return Sine(2e-3, 3, t); });
  double cosine = 0, sine = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double error = smooth.position[i] - Sine(2e-3, 3, i * kStep);
    cosine += error * std::cos(2 * M_PI * 48 * i * kStep);
    sine += error * std::sin(2 * M_PI * 48 * i * kStep);
  }
  EXPECT_LT(std::hypot(cosine, sine) / std::sqrt(kSamples), 0.1 * kNoise) << "white noise: 1";
}

TEST(MotionSmootherTest, TheDeviationsSayWhatTheErrorsAre) {
  const Motion motion = [](double t) { return Sine(1e-3, 8, t) + Sine(1e-3, 0.7, t); };
  const SmoothMotion smooth = Smoothed(motion);
  const double position = Rms([&](int i) { return smooth.position_deviation[i]; });
  const double speed = Rms([&](int i) { return smooth.speed_deviation[i]; });
  EXPECT_NEAR(PositionError(smooth, motion) / position, 1, 0.15);
  EXPECT_NEAR(SpeedError(smooth, motion) / speed, 1, 0.3);
}

/// Starts and stops within 20 ms, creeps, and rests: kinds of motion take turns, and where one gives
/// way to another their difference is uncertain, too.
double StartsAndStops(double t) {
  const double phase = std::fmod(t, 1.5);
  const double rise = std::clamp((phase - 0.4) / 0.02, 0.0, 1.0);
  const double fall = std::clamp((phase - 1.1) / 0.02, 0.0, 1.0);
  const auto smooth = [](double u) { return u * u * (3 - 2 * u); };
  const double creep = std::clamp(phase - 0.6, 0.0, 0.3) - 10 * std::clamp(phase - 1.25, 0.0, 0.03);
  return 4e-5 * (smooth(rise) - smooth(fall)) + 1e-5 * creep;
}

TEST(MotionSmootherTest, TheSpeedIsUncertainWhereKindsOfMotionTakeTurns) {
  double square = 0, surest = 1;
  constexpr int kSeeds = 5;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const SmoothMotion smooth = SmoothPosition(Measure(StartsAndStops, seed), {}, kStep, kNoise);
    square += std::pow(Rms([&](int i) {
                         const double t = i * kStep, d = 1e-5;
                         const double v = (StartsAndStops(t + d) - StartsAndStops(t - d)) / (2 * d);
                         // Of a hundredth of a percent of the quickest speed nobody asks.
                         return (smooth.speed[i] - v) / std::hypot(smooth.speed_deviation[i], 3e-7);
                       }),
                       2) /
              kSeeds;
    for (const double deviation : smooth.speed_deviation) surest = std::min(surest, deviation);
  }
  EXPECT_GT(surest, 1e-8) << "never without doubt";
  EXPECT_LT(square, 3) << "mean square of the error over what is said of it";
}

TEST(MotionSmootherTest, NothingIsRoundedOffWhereTheMotionTurnsWithinASample) {
  const Motion triangle = [](double t) {
    const double part = t / 2 - std::floor(t / 2);
    return 2e-3 * (part < 0.5 ? 4 * part - 1 : 3 - 4 * part);
  };
  const SmoothMotion smooth = Smoothed(triangle);
  double worst = 0;
  for (int i = 0; i < kSamples; ++i) {
    worst = std::max(worst, std::abs(smooth.position[i] - triangle(i * kStep)));
  }
  EXPECT_LT(worst, 5 * kNoise);
}

TEST(MotionSmootherTest, APartAtRestHasAsGoodAsNoSpeed) {
  const SmoothMotion smooth = Smoothed([](double) { return 0.01; });
  EXPECT_LT(Rms([&](int i) { return smooth.speed[i]; }), 5e-7);
  EXPECT_LT(Rms([&](int i) { return smooth.position[i] - 0.01; }), 0.15 * kNoise);
}

// Also where one model of the motion takes over from another: from rest to a quick sine and back.
TEST(MotionSmootherTest, PositionsFollowTheSpeeds) {
  const Motion motion = [](double t) {
    const double s = std::clamp(std::min(t - 4, 11 - t), 0.0, 1.0);
    return s * s * (3 - 2 * s) * Sine(1e-3, 5, t);
  };
  const SmoothMotion m = Smoothed(motion);
  const double apart = Rms([&](int i) {
    const double way = (m.position[i + 1] - m.position[i]) / kStep;
    return way - 0.5 * (m.speed[i] + m.speed[i + 1]) +
           kStep / 12 * (m.acceleration[i + 1] - m.acceleration[i]);
  });
  EXPECT_LT(apart, 9.5e-7) << "m/s of 0.03; 1.1e-6 if the shares did not move it";
}

TEST(MotionSmootherTest, SamplesNotBelievedAreBridged) {
  const Motion motion = [](double t) { return Sine(1e-3, 2, t); };
  std::vector<double> samples = Measure(motion);
  std::vector<char> bad(samples.size(), 0);
  for (int i : {1000, 1001, 1002, 1500}) samples[i] = 1, bad[i] = 1;
  const SmoothMotion smooth = SmoothPosition(samples, bad, kStep, kNoise);
  for (int i : {1000, 1001, 1002, 1500}) {
    EXPECT_NEAR(smooth.position[i], motion(i * kStep), 3 * kNoise) << i;
  }
}

// Also over a gap of many samples at a high speed, and where a record begins or ends with one.
TEST(MotionSmootherTest, LongGapsLeaveNumbers) {
  const Motion motion = [](double t) { return 0.05 * t + Sine(5e-3, 0.2, t); };
  std::vector<double> samples = Measure(motion);
  std::vector<char> bad(samples.size(), 0);
  for (const auto& [begin, end] : {std::pair{0, 30}, {44, 305}, {1200, 1230}, {2990, kSamples}}) {
    for (int i = begin; i < end; ++i) bad[i] = 1;
  }
  const SmoothMotion smooth = SmoothPosition(samples, bad, kStep, kNoise);
  for (int i = 0; i < kSamples; ++i) {
    ASSERT_TRUE(std::isfinite(smooth.position[i]) && std::isfinite(smooth.speed_deviation[i])) << i;
    if (!bad[i]) {
      EXPECT_NEAR(smooth.position[i], motion(i * kStep), 5 * kNoise) << i;
    }
  }
  EXPECT_NEAR(smooth.position[1215], motion(1215 * kStep), 2e-5);
}

// Steps, ramps and noise from nothing to 1e12 times the noise, some samples not believed.
TEST(MotionSmootherTest, WhateverComesInNumbersComeOut) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0, 1);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 60; ++run) {
    const double height = kNoise * std::pow(10.0, 12 * part(random));
    const double steps = part(random) * part(random), missing = 0.2 * part(random);
    std::vector<double> samples;
    std::vector<char> bad;
    double level = 0, slope = 0;
    for (int i = 0; i < 400; ++i) {
      if (part(random) < steps) level += height * normal(random);
      if (part(random) < steps) slope = 0.1 * height * normal(random);
      level += slope;
      samples.push_back(level + kNoise * normal(random));
      bad.push_back(part(random) < missing);
    }
    const SmoothMotion smooth = SmoothPosition(samples, bad, kStep, kNoise);
    for (int i = 0; i < 400; ++i) {
      ASSERT_TRUE(std::isfinite(smooth.position[i]) && std::isfinite(smooth.speed[i]) &&
                  std::isfinite(smooth.acceleration[i]) && std::isfinite(smooth.speed_deviation[i]))
          << "run " << run << ", sample " << i;
    }
  }
}

TEST(MotionSmootherTest, ALongRecordIsAsSmoothWhereItIsCut) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> samples;
  const auto motion = [](int i) { return Sine(1e-3, 4, i * kStep); };
  for (int i = 0; i < 70000; ++i) samples.push_back(motion(i) + kNoise * normal(random));
  const SmoothMotion smooth = SmoothPosition(samples, {}, kStep, kNoise);
  for (int i = 100; i + 100 < 70000; ++i) {
    ASSERT_NEAR(smooth.position[i], motion(i), 5 * kNoise) << i;
    ASSERT_NEAR(smooth.speed[i], 8e-3 * M_PI * std::cos(8 * M_PI * i * kStep), 8e-4) << i;
  }
}

TEST(MotionSmootherTest, NoSampleAndOneSampleAreNoMotion) {
  EXPECT_TRUE(SmoothPosition({}, {}, kStep, kNoise).position.empty());
  const SmoothMotion one = SmoothPosition({0.2}, {}, kStep, kNoise);
  ASSERT_EQ(one.position.size(), 1u);
  EXPECT_DOUBLE_EQ(one.position[0], 0.2);
}

}  // namespace
}  // namespace phs::identify
