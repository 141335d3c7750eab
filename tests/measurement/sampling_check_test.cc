// Motions below and above a quarter of their sampling rate, with noise, corners and jumps.
#include "measurement/sampling_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace phs::measurement {
namespace {

constexpr double kStep = 0.005;

Channel Sampled(const std::function<double(double)>& x, double noise = 1e-7) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  Channel out;
  out.name = "actuator_m";
  for (int i = 0; i < 12000; ++i) out.y.push_back(x(i * kStep) + noise * normal(random));
  out.bad.assign(out.y.size(), 0);
  return out;
}

double Share(const Channel& c) { return FindFastMotion(c.y, c.bad, kStep).share; }

std::function<double(double)> Sine(double f) {
  return [f](double t) { return 1e-4 * std::sin(2 * M_PI * f * t); };
}

TEST(SamplingCheck, ASineIsFastBeyondAQuarterOfTheRate) {
  EXPECT_EQ(Share(Sampled(Sine(20))), 0);
  EXPECT_EQ(Share(Sampled(Sine(42))), 0);
  EXPECT_EQ(Share(Sampled(Sine(58))), 1);
  EXPECT_EQ(Share(Sampled(Sine(80))), 1);
  const Channel fast = Sampled(Sine(60));
  EXPECT_NEAR(FindFastMotion(fast.y, fast.bad, kStep).reaches_Hz, 60, 6);
}

TEST(SamplingCheck, NoiseOnASlowMotionIsNoFastMotion) {
  const auto slow = [](double t) { return 2e-3 * std::sin(2 * M_PI * 0.3 * t); };
  for (const double noise : {1e-7, 1e-6, 4e-6}) EXPECT_EQ(Share(Sampled(slow, noise)), 0) << noise;
}

TEST(SamplingCheck, CornersAndLoneJumpsAreNone) {
  const auto triangle = [](double t) {
    return 2e-3 * (4 * std::abs(t * 0.8 - std::floor(t * 0.8 + 0.5)) - 1);
  };
  EXPECT_LT(Share(Sampled(triangle)), 0.1);
  const auto steps = [](double t) {
    return 1e-3 * std::floor(t / 3) + 2e-4 * std::sin(2 * M_PI * t);
  };
  EXPECT_LT(Share(Sampled(steps)), 0.25) << "twenty jumps in a minute";
}

TEST(SamplingCheck, ASweepIsSaidAndWhatIsFastMostOfTheTimeIsRefused) {
  RigRun run;
  run.source = "run.csv", run.step_s = kStep;
  std::vector<DataFinding> findings;
  // 1 Hz to 70 Hz: above 46 Hz, where a tenth shows above 50 Hz, for 34 % of the time.
  const auto sweep = [](double t) {
    return 1e-4 * std::sin(2 * M_PI * (t + 0.5 * 69 / 60 * t * t));
  };
  EXPECT_TRUE(CheckSampling(Sampled(sweep), run, &findings).ok());
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_THAT(findings[0].text, testing::HasSubstr("a quarter of its 200 Hz of sampling for 3"));
  const Status refused = CheckSampling(Sampled(Sine(70)), run, &findings);
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(refused.error().Line(), testing::HasSubstr("low_pass_Hz: 40"));
}

}  // namespace
}  // namespace phs::measurement
