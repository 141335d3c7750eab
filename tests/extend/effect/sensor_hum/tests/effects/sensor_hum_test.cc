// Hum on the channels of a rig: added to those named, absent from the others.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/driven_cylinder.h"

namespace phs::effects {
namespace {

TEST(SensorHum, IsAddedToTheLoadCellAlone) {
  const auto plain = ChannelsOfASine(Quarter(), 0.01, 200);
  const auto hum = ChannelsOfASine(
      With(Quarter(), "sensor_hum", {{"load_N", 40}, {"frequency_Hz", 7}}), 0.01, 200);
  for (size_t i = 0; i < plain[1].size(); ++i) {
    const double expected = 40 * std::sin(2 * M_PI * 7 * 0.01 * static_cast<double>(i));
    EXPECT_NEAR(hum[1][i] - plain[1][i], expected, 1e-9);
  }
  EXPECT_EQ(hum[2], plain[2]);
  EXPECT_EQ(hum[3], plain[3]);
}

}  // namespace
}  // namespace phs::effects
