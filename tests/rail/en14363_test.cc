#include "rail/en14363.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "rail/signal_filter.h"

namespace phs::rail {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<double> Sine(double frequency, double rate, int count) {
  std::vector<double> s;
  for (int i = 0; i < count; ++i) s.push_back(std::sin(2 * kPi * frequency * i / rate));
  return s;
}

/// Gain of the settled second half.
double Gain(const std::vector<double>& filtered) {
  const std::vector<double> half(filtered.begin() + static_cast<long>(filtered.size() / 2),
                                 filtered.end());
  return Rms(half) * std::sqrt(2.0);
}

// Butterworth, order 4: 1/sqrt(1 + (tan(pi f/fs)/tan(pi fc/fs))^8) after the bilinear transform.
TEST(SignalFilter, LowPassHasButterworthGainAndMinus3dBAtTheCutOff) {
  const double rate = 1000;
  for (double f : {1.0, 10.0, 20.0, 40.0, 80.0}) {
    const auto y = LowPass(Sine(f, rate, 20000), rate, 20);
    ASSERT_TRUE(y.ok());
    const double ratio = std::tan(kPi * f / rate) / std::tan(kPi * 20 / rate);
    EXPECT_NEAR(Gain(y.value()), 1 / std::sqrt(1 + std::pow(ratio, 8)), 2e-4) << f;
  }
  EXPECT_NEAR(Gain(LowPass(Sine(20, rate, 20000), rate, 20).value()), std::sqrt(0.5), 2e-4);
}

TEST(SignalFilter, HighPassHasButterworthGain) {
  const double rate = 1000;
  for (double f : {5.0, 10.0, 20.0, 100.0}) {
    const auto y = HighPass(Sine(f, rate, 20000), rate, 10);
    ASSERT_TRUE(y.ok());
    const double ratio = std::tan(kPi * 10 / rate) / std::tan(kPi * f / rate);
    EXPECT_NEAR(Gain(y.value()), 1 / std::sqrt(1 + std::pow(ratio, 8)), 2e-4) << f;
  }
}

TEST(SignalFilter, ConstantsPassTheLowPassAndNotTheBand) {
  const std::vector<double> constant(500, 7.5);
  const std::vector<double> low = LowPass(constant, 200, 20).value();
  const std::vector<double> band = BandPass(constant, 200, 0.4, 10).value();
  for (double value : low) EXPECT_NEAR(value, 7.5, 1e-11);
  for (double value : band) EXPECT_NEAR(value, 0, 1e-11);
}

TEST(SignalFilter, BadCutOffIsNamed) {
  const auto y = LowPass({1, 2, 3}, 30, 20);
  ASSERT_FALSE(y.ok());
  EXPECT_NE(y.error().Line().find("half the sample rate"), std::string::npos);
  EXPECT_FALSE(LowPass({}, 100, 20).ok());
  EXPECT_FALSE(BandPass({1, 2}, 100, 10, 5).ok());
}

TEST(SlidingMean, ExactForALineAtChangingSpeed) {
  std::vector<double> x, y;
  for (int i = 0; i <= 100; ++i) {
    x.push_back(3 + 0.001 * i * i);  // 3 … 13 m
    y.push_back(2 * x.back() - 1);
  }
  const auto mean = SlidingMean(x, y, 2, 0.5);
  ASSERT_TRUE(mean.ok());
  ASSERT_EQ(mean.value().size(), 17u);
  for (std::size_t k = 0; k < mean.value().size(); ++k) {
    EXPECT_NEAR(mean.value()[k], 2 * (4 + 0.5 * static_cast<double>(k)) - 1, 1e-10);
  }
}

// A wave of length L under a window w keeps sin(pi w/L)/(pi w/L) of its height.
TEST(SlidingMean, AttenuatesAWaveBySinc) {
  std::vector<double> x, y;
  const double length = 6;
  for (int i = 0; i <= 60000; ++i) {
    x.push_back(1e-3 * i);
    y.push_back(std::cos(2 * kPi * x.back() / length));
  }
  const auto mean = SlidingMean(x, y, 2, 0.5);
  ASSERT_TRUE(mean.ok());
  const double sinc = std::sin(kPi * 2 / length) / (kPi * 2 / length);
  for (std::size_t k = 0; k < mean.value().size(); ++k) {
    const double centre = 1 + 0.5 * static_cast<double>(k);
    EXPECT_NEAR(mean.value()[k], sinc * std::cos(2 * kPi * centre / length), 1e-6);
  }
}

TEST(SlidingMean, RmsOfAWaveAndOfALine) {
  std::vector<double> x, y, line;
  for (int i = 0; i <= 20000; ++i) {
    x.push_back(1e-2 * i);
    y.push_back(3 * std::sin(2 * kPi * x.back() / 5));
    line.push_back(x.back());
  }
  const std::vector<double> wave = SlidingRms(x, y, 100, 10).value();
  ASSERT_EQ(wave.size(), 11u);
  for (double rms : wave) EXPECT_NEAR(rms, 3 / std::sqrt(2.0), 1e-4);
  EXPECT_NEAR(SlidingRms(x, line, 100, 10).value()[0], 100 / std::sqrt(3.0), 1e-9);
}

TEST(SlidingMean, ShortWayAndFallingDistance) {
  EXPECT_TRUE(SlidingMean({0, 1}, {1, 1}, 2, 0.5).value().empty());
  EXPECT_EQ(SlidingMean({0, 2}, {1, 3}, 2, 0.5).value().size(), 1u);
  EXPECT_FALSE(SlidingMean({0, 2, 1}, {1, 1, 1}, 1, 0.5).ok());
  EXPECT_FALSE(SlidingMean({0, 2}, {1, 1, 1}, 1, 0.5).ok());
  // Standing still: repeated distances carry no weight.
  EXPECT_NEAR(SlidingMean({0, 1, 1, 1, 2}, {4, 4, 9, 4, 4}, 2, 0.5).value()[0], 4, 1e-12);
}

TEST(Percentile, LinearBetweenSortedSamples) {
  EXPECT_DOUBLE_EQ(Percentile({3, 1, 2, 5, 4}, 50), 3);
  EXPECT_DOUBLE_EQ(Percentile({3, 1, 2, 5, 4}, 0), 1);
  EXPECT_DOUBLE_EQ(Percentile({3, 1, 2, 5, 4}, 100), 5);
  EXPECT_DOUBLE_EQ(Percentile({3, 1, 2, 5, 4}, 12.5), 1.5);
  EXPECT_TRUE(std::isnan(Percentile({}, 50)));
  EXPECT_DOUBLE_EQ(PercentileSize({-9, 0, 1, 2}, 100), 9);
}

RC_GTEST_PROP(PercentileProperty, BetweenTheExtremesAndMonotone, ()) {
  const auto numbers =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(-1000, 1000)));
  const std::vector<double> samples(numbers.begin(), numbers.end());
  double last = Percentile(samples, 0);
  RC_ASSERT(last == *std::min_element(samples.begin(), samples.end()));
  for (double percent = 5; percent <= 100; percent += 5) {
    const double value = Percentile(samples, percent);
    RC_ASSERT(value >= last);
    last = value;
  }
  RC_ASSERT(last == *std::max_element(samples.begin(), samples.end()));
}

WheelsetRecord Steady() {
  WheelsetRecord r;
  r.sample_rate = 500;
  r.static_wheel_load = 127.5e3;
  for (int i = 0; i < 10000; ++i) {
    r.distance.push_back(0.04 * i);  // 20 m/s
    r.y_left.push_back(40e3);
    r.y_right.push_back(-12e3);
    r.q_left.push_back(140e3);
    r.q_right.push_back(115e3);
  }
  return r;
}

TEST(En14363, ASteadyCurveGivesItsOwnForces) {
  const auto s = CalcWheelsetStatistics(Steady());
  ASSERT_TRUE(s.ok());
  EXPECT_NEAR(s.value().sum_y_2m, 28e3, 1e-6);
  EXPECT_NEAR(s.value().left.y_qst, 40e3, 1e-6);
  EXPECT_NEAR(s.value().left.y_over_q_2m, 40.0 / 140, 1e-9);
  EXPECT_NEAR(s.value().right.y_over_q_2m, 12.0 / 115, 1e-9);
  EXPECT_NEAR(s.value().left.q_max, 140e3, 1e-6);
  EXPECT_NEAR(s.value().right.unloading, 1 - 115 / 127.5, 1e-9);
  EXPECT_EQ(s.value().sum_y_rms_max, 0);
  EXPECT_NEAR(s.value().length, 0.04 * 9999, 1e-9);
}

// Hunting at 5 Hz shows in the rms of its band, at 20 m/s (wave length 4 m) with sinc(1/2) in 2 m
// means, and not at all when a 60 Hz tremor replaces it.
TEST(En14363, HuntingAndTremorAreToldApart) {
  WheelsetRecord r = Steady();
  r.instability_frequency = 5;
  for (std::size_t i = 0; i < r.distance.size(); ++i) {
    r.y_left[i] = 10e3 * std::sin(2 * kPi * 5 * static_cast<double>(i) / r.sample_rate);
    r.y_right[i] = 0;
  }
  const auto hunting = CalcWheelsetStatistics(r);
  ASSERT_TRUE(hunting.ok());
  // Gain of the band from 3 to 7 Hz at 5 Hz.
  const double gain = 1 / std::sqrt((1 + std::pow(0.6, 8)) * (1 + std::pow(5.0 / 7, 8)));
  EXPECT_NEAR(hunting.value().sum_y_rms_max, gain * 10e3 / std::sqrt(2.0), 20);
  EXPECT_NEAR(hunting.value().sum_y_2m, 10e3 * 2 / kPi, 0.02 * 6366);
  for (std::size_t i = 0; i < r.distance.size(); ++i) {
    r.y_left[i] = 10e3 * std::sin(2 * kPi * 60 * static_cast<double>(i) / r.sample_rate);
  }
  const auto tremor = CalcWheelsetStatistics(r);
  ASSERT_TRUE(tremor.ok());
  EXPECT_LT(tremor.value().sum_y_2m, 100);
  EXPECT_LT(tremor.value().sum_y_rms_max, 400);
}

TEST(En14363, AccelerationInItsBand) {
  const auto s = CalcAccelerationStatistics(Sine(3, 200, 40000), 200);
  ASSERT_TRUE(s.ok());
  EXPECT_NEAR(s.value().rms, std::sqrt(0.5), 0.01);
  EXPECT_NEAR(s.value().peak, 1, 0.01);
}

// 26 t axle: sum Y 95.0 kN, Q at most 200 kN; R = 300 m: Yqst 30 + 10500/300 = 65 kN.
TEST(En14363, LimitsOfA26TonneAxle) {
  const RunningLimits limits = CalcRunningLimits(127.5e3, 300, 1);
  EXPECT_NEAR(limits.sum_y_2m, 95e3, 1);
  EXPECT_NEAR(limits.sum_y_rms, 47.5e3, 1);
  EXPECT_DOUBLE_EQ(limits.y_qst, 65e3);
  EXPECT_DOUBLE_EQ(limits.q_max, 200e3);
  EXPECT_DOUBLE_EQ(CalcRunningLimits(100e3, -550, 1).q_max, 190e3);
  EXPECT_DOUBLE_EQ(CalcRunningLimits(127.5e3, 550, 1).y_qst, 60e3);
  EXPECT_EQ(CurveClassOf(550), "small");
  EXPECT_EQ(CurveClassOf(-300), "very small");
  EXPECT_EQ(CurveClassOf(0), "straight");
}

TEST(En14363, BrokenRecordsAreNamed) {
  WheelsetRecord r = Steady();
  r.q_left.pop_back();
  EXPECT_FALSE(CalcWheelsetStatistics(r).ok());
  r = Steady();
  r.static_wheel_load = 0;
  EXPECT_NE(CalcWheelsetStatistics(r).error().Line().find("static_wheel_load"), std::string::npos);
  r = Steady();
  r.sample_rate = 30;
  EXPECT_NE(CalcWheelsetStatistics(r).error().Line().find("cut-off"), std::string::npos);
}

}  // namespace
}  // namespace phs::rail
