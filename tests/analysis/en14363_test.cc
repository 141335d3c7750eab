#include "analysis/en14363.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/running_statistics.h"

namespace phs::analysis {
namespace {

constexpr double kInterval = 0.002;

std::vector<double> SampledSine(double frequency, double amplitude, double mean, int count) {
  std::vector<double> signal;
  for (int i = 0; i < count; ++i) {
    signal.push_back(mean + amplitude * std::sin(2 * std::numbers::pi * frequency * i * kInterval));
  }
  return signal;
}

double AmplitudeOfSecondHalf(const std::vector<double>& signal) {
  return *std::max_element(signal.begin() + static_cast<long>(signal.size() / 2), signal.end());
}

std::vector<double> Places(int count, double speed) {
  std::vector<double> places;
  for (int i = 0; i < count; ++i) places.push_back(100 + speed * kInterval * i);
  return places;
}

// A Butterworth filter has 1/sqrt(2) at its cut-off and, of 4th order, 1/sqrt(1 + 2^8) an octave
// beyond (bilinear: of the warped frequencies).
TEST(Filters, ButterworthOfFourthOrder) {
  const auto low = LowPass(SampledSine(20, 1, 0, 4000), kInterval, 20);
  const auto high = HighPass(SampledSine(20, 1, 0, 4000), kInterval, 20);
  const auto octave = LowPass(SampledSine(40, 1, 0, 4000), kInterval, 20);
  ASSERT_TRUE(low.ok() && high.ok() && octave.ok());
  EXPECT_NEAR(AmplitudeOfSecondHalf(low.value()), std::sqrt(0.5), 2e-3);
  EXPECT_NEAR(AmplitudeOfSecondHalf(high.value()), std::sqrt(0.5), 2e-3);
  const double ratio =
      std::tan(std::numbers::pi * 40 * kInterval) / std::tan(std::numbers::pi * 20 * kInterval);
  EXPECT_NEAR(AmplitudeOfSecondHalf(octave.value()), 1 / std::sqrt(1 + std::pow(ratio, 8)), 1e-3);
}

TEST(Filters, KeepConstantOrRemoveIt) {
  const std::vector<double> constant(100, 7.0);
  const auto low = LowPass(constant, kInterval, 20);
  const auto high = HighPass(constant, kInterval, 0.4);
  ASSERT_TRUE(low.ok() && high.ok());
  for (double value : low.value()) EXPECT_NEAR(value, 7, 1e-9);
  for (double value : high.value()) EXPECT_NEAR(value, 0, 1e-9);
}

TEST(Filters, RefuseSlowSampling) {
  EXPECT_FALSE(LowPass({1, 2}, 0.025, 20).ok());
  EXPECT_FALSE(LowPass({1, 2}, 0, 20).ok());
}

TEST(SlidingMean, OfALineIsItsMiddle) {
  const std::vector<double> places = {0, 0.7, 1.5, 3, 4};
  const auto means = SlidingMean(places, places, 2, 0.5);
  ASSERT_TRUE(means.ok());
  ASSERT_EQ(means.value().size(), 5u);  // begins at 0, 0.5 … 2
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(means.value()[i], 1 + 0.5 * i, 1e-12);
}

TEST(SlidingMean, ShortOrStandingRun) {
  EXPECT_TRUE(SlidingMean({0, 1}, {1, 1}, 2, 0.5).value().empty());
  EXPECT_FALSE(SlidingMean({0, 1, 0.9}, {1, 1, 1}, 0.5, 0.5).ok());
  EXPECT_NEAR(SlidingMean({0, 1, 1, 1, 2, 2}, {4, 4, 9, 4, 4, 8}, 2, 0.5).value()[0], 4, 1e-12);
}

TEST(SlidingRms, OfASineIsItsAmplitudeOverRootTwo) {
  const std::vector<double> places = Places(5000, 20);
  const auto rms = SlidingRms(places, SampledSine(4, 3, 0, 5000), 100, 10);
  ASSERT_TRUE(rms.ok());
  for (double value : rms.value()) EXPECT_NEAR(value, 3 / std::sqrt(2.0), 0.02);
}

TEST(PercentileOf, Ranks) {
  EXPECT_DOUBLE_EQ(Percentile({3, 1, 2}, 50), 2);
  EXPECT_DOUBLE_EQ(Percentile({0, 10}, 99.85), 9.985);
  EXPECT_TRUE(std::isnan(Percentile({}, 50)));
}

WheelsetForces Steady(int count) {
  WheelsetForces f;
  f.distance_m = Places(count, 20);
  f.y_left_N.assign(count, -20e3);
  f.y_right_N.assign(count, 50e3);
  f.q_left_N.assign(count, 80e3);
  f.q_right_N.assign(count, 125e3);
  return f;
}

SectionConditions Conditions() { return {kInterval, 127.5e3, 550, 1, 0}; }

TEST(AssessWheelset, SteadyForcesComeBack) {
  const auto rows = AssessWheelset(Steady(2000), Conditions());
  ASSERT_TRUE(rows.ok());
  const double expected[] = {30e3, 0.4, 125e3, 50e3, 125e3, 1 - 80 / 127.5};
  const double limit[] = {95e3, 0.8, 200e3, 60e3, 145e3, 1};
  ASSERT_EQ(rows.value().size(), 6u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(rows.value()[i].value, expected[i], 1e-6 * expected[i]) << rows.value()[i].name;
    EXPECT_NEAR(rows.value()[i].limit, limit[i], 1e-6 * limit[i]) << rows.value()[i].name;
    EXPECT_TRUE(rows.value()[i].kept());
  }
}

TEST(AssessWheelset, SmallRadiusAllowsMoreQuasiStaticForce) {
  SectionConditions c = Conditions();
  c.radius_m = 250;
  EXPECT_NEAR(AssessWheelset(Steady(2000), c).value()[3].limit, 72e3, 1);
}

/// A blow shorter than 2 m is averaged away, a longer one is not.
TEST(AssessWheelset, TwoMetreMean) {
  const auto sum_y = [](int samples) {
    WheelsetForces f = Steady(2000);
    for (int i = 1000; i < 1000 + samples; ++i) f.y_right_N[i] += 100e3;
    return AssessWheelset(f, Conditions()).value()[0].value;
  };
  EXPECT_LT(sum_y(10), 30e3 + 25e3);   // 0.4 m
  EXPECT_GT(sum_y(200), 30e3 + 95e3);  // 8 m
}

TEST(AssessWheelset, HuntingShowsInTheBand) {
  WheelsetForces f = Steady(5000);
  const std::vector<double> hunting = SampledSine(5, 40e3, 0, 5000);
  for (int i = 0; i < 5000; ++i) f.y_left_N[i] += hunting[i];
  SectionConditions c = Conditions();
  c.hunting_Hz = 5;
  const auto rows = AssessWheelset(f, c);
  ASSERT_TRUE(rows.ok());
  // The band from 3 to 7 Hz lets this share of 5 Hz through.
  const double share = 1 / std::sqrt((1 + std::pow(3 / 5.0, 8)) * (1 + std::pow(5 / 7.0, 8)));
  EXPECT_NEAR(rows.value()[6].value, share * 40e3 / std::sqrt(2.0), 100);
  EXPECT_NEAR(rows.value()[6].limit, 47.5e3, 1);
}

TEST(AssessWheelset, RefusesWhatItCannotAssess) {
  WheelsetForces f = Steady(2000);
  f.q_left_N.pop_back();
  EXPECT_FALSE(AssessWheelset(f, Conditions()).ok());
  EXPECT_FALSE(AssessWheelset(Steady(20), Conditions()).ok());
  SectionConditions c = Conditions();
  c.static_wheel_load_N = 0;
  EXPECT_FALSE(AssessWheelset(Steady(2000), c).ok());
}

TEST(AssessAcceleration, BandAndRms) {
  const auto inside = AssessAcceleration(SampledSine(2, 0.5, 9.81, 20000), kInterval);
  const auto outside = AssessAcceleration(SampledSine(60, 5, 0, 20000), kInterval);
  ASSERT_TRUE(inside.ok() && outside.ok());
  EXPECT_NEAR(inside.value().rms, 0.5 / std::sqrt(2.0), 5e-3);
  EXPECT_NEAR(inside.value().high, 0.5, 0.02);  // the start of the sine rings a little
  EXPECT_NEAR(inside.value().low, -0.5, 0.02);
  EXPECT_LT(outside.value().rms, 0.01);
}

}  // namespace
}  // namespace phs::analysis
