// Readings that sag with their common supply.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

constexpr size_t kPiston = 0, kForce = 1, kFirstPressure = 2, kLastPressure = 3;
constexpr double kClock = 0.005;
constexpr int kCount = 1600;

std::vector<std::vector<double>> Sagging(std::map<std::string, double> values) {
  return ChannelsOfASine(With(Quarter(), "sensor_supply", std::move(values)), kClock, kCount);
}

/// Central difference of what the piston does.
double SpeedAt(const std::vector<double>& x, size_t i) {
  return (x[i + 1] - x[i - 1]) / (2 * kClock);
}

// With |v|, and with the power that goes in, all three readings by one share; pressures absolute.
TEST(SensorSupply, AllReadingsLoseOneShare) {
  const auto plain = ChannelsOfASine(Quarter(), kClock, kCount);
  const auto speed = Sagging({{"of_speed", 0.02}}), power = Sagging({{"of_power", 0.5}});
  int drawn = 0;
  for (size_t i = 1; i + 1 < kCount; i += 7) {
    const double v = SpeedAt(plain[kPiston], i);
    const double of_speed = 0.02 * std::abs(v) / 0.01;
    const double of_power = 0.5 * std::max(plain[kForce][i] * v, 0.0) / 1e3;
    drawn += of_power > 1e-3;
    for (size_t c = kForce; c <= kLastPressure; ++c) {
      EXPECT_NEAR(speed[c][i] / plain[c][i], 1 - of_speed, 1e-9) << c << " " << i;
      EXPECT_NEAR(power[c][i] / plain[c][i], 1 - of_power, 1e-9) << c << " " << i;
    }
    EXPECT_EQ(speed[kPiston][i], plain[kPiston][i]);
  }
  EXPECT_GT(drawn, 50);
}

TEST(SensorSupply, AReadingMayHaveAPartOfItsOwn) {
  const auto plain = ChannelsOfASine(Quarter(), kClock, kCount);
  const auto shown = Sagging({{"of_speed", 0.02}, {"load", 0}, {"p_rod", 2.5}});
  for (size_t i = 1; i + 1 < kCount; i += 7) {
    const double y = 0.02 * std::abs(SpeedAt(plain[kPiston], i)) / 0.01;
    EXPECT_EQ(shown[kForce][i], plain[kForce][i]);
    EXPECT_NEAR(shown[kFirstPressure][i] / plain[kFirstPressure][i], 1 - y, 1e-9);
    EXPECT_NEAR(shown[kLastPressure][i] / plain[kLastPressure][i], 1 - 2.5 * y, 1e-9);
  }
}

// T dy'/dt = y - y', over a hundred small steps of each sample.
TEST(SensorSupply, FollowsWithItsTime) {
  const double T = 0.2;
  const auto plain = ChannelsOfASine(Quarter(), kClock, kCount);
  const auto shown = Sagging({{"of_speed", 0.05}, {"time_s", T}});
  const auto share = [&](size_t i) { return 0.05 * std::abs(SpeedAt(plain[kPiston], i)) / 0.01; };
  // From a sample on where its own lag is known.
  double y = 1 - shown[kForce][1] / plain[kForce][1], least = 1, most = 0;
  for (size_t i = 2; i + 1 < kCount; ++i) {
    for (int k = 0; k < 100; ++k) {
      const double now = share(i - 1) + (share(i) - share(i - 1)) * (k + 0.5) / 100;
      y += kClock / 100 * (now - y) / T;
    }
    EXPECT_NEAR(1 - shown[kFirstPressure][i] / plain[kFirstPressure][i], y, 1e-6) << i;
    if (i > kCount / 2) least = std::min(least, y), most = std::max(most, y);
  }
  EXPECT_GT(least, 0.005) << "it does not follow to rest";
  EXPECT_LT(most, 0.05 * 4e-3 / 0.01) << "nor to the full";
}

}  // namespace
}  // namespace phs::effects
