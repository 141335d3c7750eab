// What a gauge picks up of other channels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

constexpr int kBore = 2, kRod = 3, kLoad = 1, kSamples = 1600;
constexpr double kStep = 0.005;

// A copy, however slow: above static; of the load cell as it is.
TEST(Crosstalk, IsAShareOfTheOtherChannel) {
  const PhsParams p = Quarter();
  const auto plain = ChannelsOfASine(p, kStep, kSamples);
  const auto gauge =
      ChannelsOfASine(With(p, "sensor_crosstalk", {{"p_bore_of_p_rod", 0.02}}), kStep, kSamples);
  const auto load =
      ChannelsOfASine(With(p, "sensor_crosstalk", {{"p_rod_Pa_per_N", -1.5}}), kStep, kSamples);
  for (const size_t i : {0u, 100u, 700u, 1500u}) {
    const double rise = plain[kRod][i] - p.lines[0].static_pressure_Pa;
    EXPECT_NEAR(gauge[kBore][i], plain[kBore][i] + 0.02 * rise, 1e-6);
    EXPECT_DOUBLE_EQ(gauge[kRod][i], plain[kRod][i]);
    EXPECT_NEAR(load[kRod][i], plain[kRod][i] - 1.5 * plain[kLoad][i], 1e-6);
  }
}

// Through a capacitance: far above 1/T a copy, far below it T times the rate.
TEST(Crosstalk, ACapacitancePassesWhatIsQuick) {
  const PhsParams p = Quarter();
  const auto plain = ChannelsOfASine(p, kStep, kSamples);
  const auto with = [&](double time_s) {
    return ChannelsOfASine(
        With(p, "sensor_crosstalk", {{"p_rod_of_p_bore", 0.05}, {"time_s", time_s}}), kStep,
        kSamples);
  };
  const auto slow = with(1e5), quick = with(2e-3);
  for (const size_t i : {300u, 777u, 1500u}) {
    EXPECT_NEAR(slow[kRod][i] - plain[kRod][i], 0.05 * (plain[kBore][i] - plain[kBore][0]), 10);
    const double rate = (plain[kBore][i + 1] - plain[kBore][i - 1]) / (2 * kStep);
    EXPECT_NEAR(quick[kRod][i] - plain[kRod][i], 0.05 * 2e-3 * rate, 0.02 * 0.05 * 2e-3 * 5e6) << i;
  }
}

// Between: T dz/dt = u - z over a hundred small steps of each sample.
TEST(Crosstalk, FallsBackWithItsOwnTime) {
  const PhsParams p = Quarter();
  const double T = 0.25, a = 0.1;
  const auto plain = ChannelsOfASine(p, kStep, kSamples);
  const auto shown = ChannelsOfASine(
      With(p, "sensor_crosstalk", {{"p_bore_of_p_rod", a}, {"time_s", T}}), kStep, kSamples);
  double z = plain[kRod][0], most = 0;
  for (size_t i = 1; i < kSamples; ++i) {
    for (int k = 0; k < 100; ++k) {
      const double u = plain[kRod][i - 1] + (plain[kRod][i] - plain[kRod][i - 1]) * (k + 0.5) / 100;
      z += kStep / 100 * (u - z) / T;
    }
    const double picked = a * (plain[kRod][i] - z);
    most = std::max(most, std::abs(picked));
    EXPECT_NEAR(shown[kBore][i] - plain[kBore][i], picked, 200) << i;
  }
  EXPECT_GT(most, 5e4);
}

}  // namespace
}  // namespace phs::effects
