// Channels that hold their last value: told from what stands still for reasons of its own.
#include "measurement/held_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace phs::measurement {
namespace {

constexpr double kClock_s = 0.005, kNoise = 5e3;  // s, Pa
constexpr int kRows = 8000;

/// A pressure that swings by 2 MPa, slowly and fast.
std::vector<double> Swinging() {
  std::vector<double> p;
  for (int i = 0; i < kRows; ++i) {
    const double t = i * kClock_s;
    p.push_back(5e6 + 2e6 * std::sin(2 * M_PI * 0.3 * t) + 2e5 * std::sin(2 * M_PI * 2.1 * t));
  }
  return p;
}

FitData With(std::vector<double> values) {
  FitData data;
  data.step_s = kClock_s;
  std::mt19937 random(11);
  std::normal_distribution<double> normal(0, kNoise);
  for (double& y : values) y += normal(random);
  data.outputs = {{"p_rod_Pa", std::move(values), kNoise}};
  return data;
}

// Forty holds of 0.1 to 0.4 s, noise behind them; the model's swing is 20 % off.
TEST(HeldFrames, AreLeftOutUpToTheJump) {
  const std::vector<double> p = Swinging();
  std::vector<double> held = p, model = p;
  for (double& y : model) y = 5e6 + 0.8 * (y - 5e6);
  std::vector<char> lost(p.size(), 0);
  for (size_t k = 0; k < 40; ++k) {
    const size_t begin = 100 + 190 * k, length = 20 + 60 * (k % 7) / 6;
    for (size_t i = begin + 1; i < begin + length; ++i) held[i] = p[begin], lost[i] = 1;
  }
  FitData data = With(held);
  LeaveOutHeld({model}, &data);
  ASSERT_EQ(data.findings.size(), 1u);
  EXPECT_THAT(data.findings[0].text, testing::HasSubstr("holds its last value"));
  int kept_wrong = 0, left_right = 0;
  for (size_t i = 0; i < lost.size(); ++i) {
    const bool out = !std::isfinite(data.outputs[0].values[i]);
    // A hold where the pressure turns says nothing wrong.
    kept_wrong += lost[i] && !out && std::abs(held[i] - p[i]) > 20 * kNoise;
    left_right += out && !lost[i];
  }
  const auto all = std::count(lost.begin(), lost.end(), 1);
  EXPECT_LT(kept_wrong, 0.1 * static_cast<double>(all));
  EXPECT_LT(left_right, 0.1 * static_cast<double>(all)) << "samples before, within the noise";
}

TEST(HeldFrames, SoundChannelsStay) {
  const std::vector<double> p = Swinging();
  std::vector<double> model = p;
  for (double& y : model) y = 5e6 + 0.5 * (y - 5e6);
  for (const auto& by : {p, model}) {
    FitData data = With(p);
    LeaveOutHeld({by}, &data);
    EXPECT_TRUE(data.findings.empty());
  }
}

// A vapour pressure or a play stands still, too, and goes on from there; the model knows neither.
TEST(HeldFrames, WhatStandsStillAndGoesOnFromThereIsTrue) {
  const std::vector<double> p = Swinging();
  std::vector<double> vapour = p, play = p;
  double at = p[0];
  for (size_t i = 0; i < p.size(); ++i) {
    vapour[i] = std::max(p[i], 3.6e6);
    at = std::clamp(at, p[i] - 3e5, p[i] + 3e5), play[i] = at;
  }
  for (const auto& truth : {vapour, play}) {
    FitData data = With(truth);
    LeaveOutHeld({p}, &data);
    EXPECT_TRUE(data.findings.empty());
  }
}

// Friction that turns jumps, in the model as in the record, here two samples later.
TEST(HeldFrames, AForceThatTurnsAfterARestIsTrue) {
  std::vector<double> force, later;
  for (int i = 0; i < kRows; ++i) {
    force.push_back(i / 400 % 2 == 0 ? 2e6 : -1.6e6);
    later.push_back(force[static_cast<size_t>(std::max(i - 2, 0))]);
  }
  FitData data = With(later);
  LeaveOutHeld({force}, &data);
  EXPECT_TRUE(data.findings.empty());
}

}  // namespace
}  // namespace phs::measurement
