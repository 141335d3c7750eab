#include "measurement/band_limit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace phs::identify {

using measurement::BandLimit;
namespace {

/// Gain of the filter for a sine of this frequency at 1 kHz, from the middle of the record.
double Gain(const BandLimit& band, double hertz) {
  std::vector<double> y;
  for (int i = 0; i < 8000; ++i) y.push_back(std::sin(2 * M_PI * hertz * i * 1e-3));
  const std::vector<double> z = band.Filter(y);
  double square = 0, dot = 0;
  for (int i = 2000; i < 6000; ++i) square += y[i] * y[i], dot += y[i] * z[i];
  return dot / square;
}

TEST(BandLimit, PassesTheBandWithoutLagAndStopsTheRest) {
  const BandLimit band(1e-3, 40);
  EXPECT_EQ(band.stride(), 10);
  EXPECT_NEAR(Gain(band, 0.5), 1, 0.012) << "0.1 dB ripple";
  EXPECT_NEAR(Gain(band, 20), 1, 0.012);
  EXPECT_NEAR(Gain(band, 39), 1, 0.012);
  EXPECT_LT(std::abs(Gain(band, 80)), 1e-4);
  const std::vector<double> level(3000, 7.0);
  for (const double z : band.Filter(level)) ASSERT_NEAR(z, 7, 0.09);
}

TEST(BandLimit, WithoutABandEverythingPasses) {
  const BandLimit all(1e-3, 0);
  EXPECT_TRUE(all.passes_all());
  EXPECT_EQ(all.Apply({1, 5, 2}), (std::vector<double>{1, 5, 2}));
}

}  // namespace
}  // namespace phs::identify
