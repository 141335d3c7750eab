// Waves over time and place that no effect holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/identify/search_record.h"

namespace phs::identify::search {

using measurement::FitData;
namespace {

TEST(WaveFormulas, AVibrationOfTheFrameIsAWaveInTime) {
  const FitData data = Record(WithUnlisted("c1*sin(2*pi*t/0.13[s])", "c1_N", 150, {}));
  const Identification found = Find(Declared(), data);
  ASSERT_EQ(found.effects.size(), 1u);
  EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
  const std::string text = found.formula.text;
  ASSERT_THAT(text, testing::HasSubstr("sin(2*pi*t/"));
  EXPECT_NEAR(std::stod(text.substr(text.find("t/") + 2)), 0.13, 1e-4 * 0.13);
}

/// What the inverter of a drive sends into the load cell's cable grows with the speed.
TEST(WaveFormulas, AHumThatGrowsWithTheSpeedIsAWaveTimesIt) {
  const FitData data =
      Record(WithUnlisted("c1*(abs(v)/0.01[m/s])*sin(2*pi*t/0.077[s])", "c1_N", 400, {}));
  const Identification found = FindAmong({"sensor_gain", "viscous_friction"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  const std::string text = found.formula.text;
  ASSERT_THAT(text, testing::StartsWith("c1*(abs(v)/")) << Said(found);
  ASSERT_THAT(text, testing::HasSubstr("*sin(2*pi*t/"));
  EXPECT_NEAR(std::stod(text.substr(text.find("t/") + 2)), 0.077, 1e-4 * 0.077);
  EXPECT_LT(found.after.channel_ms[1], 1.1 * LeftOnACleanRecord());
}

TEST(WaveFormulas, ACyclicErrorOfThePistonsSensorIsItsReading) {
  // Of a sensor that was set to zero where the motion begins, or not.
  for (const char* wave : {"c1*sin(2*pi*x/0.0009[m])", "c1*cos(2*pi*x/0.0009[m])"}) {
    const FitData data = Record(WithUnlisted(wave, "c1_m", 1e-5, {}));
    const Identification found = Find(Declared(), data);
    ASSERT_EQ(found.effects.size(), 1u) << wave;
    EXPECT_EQ(found.effects[0].candidate.effect, "unlisted");
    EXPECT_EQ(found.formula.unit, "m");
    const std::string text = found.formula.text;
    EXPECT_NEAR(std::stod(text.substr(text.find("x/") + 2)), 9e-4, 9e-6);
    EXPECT_LT(found.after.channel_ms[0], 1.1) << text;
  }
}

}  // namespace
}  // namespace phs::identify::search
