// What is otherwise beyond a place or a force: formulas with a step of finite width.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/identify/search_record.h"

namespace phs::identify::search {
namespace {

using measurement::FitData;

// An amplifier that crosses zero badly, about -8 kN: within 2 kN of it nothing moves.
TEST(StepFormulaTest, AnAmplifierWithADeadZoneIsAStepOverItsForce) {
  FitData data = Record(OffDeclared());
  for (double& F : data.outputs[1].values) F -= 2e3 * std::tanh((F + 8e3) / 2e3);
  const Identification found = FindAmong(
      {"sensor_gain", "sensor_offset", "backlash", "stribeck", "sensor_hysteresis"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  const std::string& text = found.formula.text;
  ASSERT_THAT(text, testing::StartsWith("c1*tanh((F+")) << Said(found);
  EXPECT_NEAR(std::stod(text.substr(text.find("F+") + 2)), 8e3, 200) << text;
  EXPECT_NEAR(found.after.values.back(), -2e3, 50) << Said(found);
  EXPECT_LT(found.after.channel_ms[1], 0.05 * found.before.channel_ms[1]);
}

// Two rulers end to end, 12 µm too far apart, at 0.7 mm.
TEST(StepFormulaTest, AScaleWithAJointIsAStepOverThePosition) {
  FitData data = Record(OffDeclared());
  for (double& x : data.outputs[0].values) x += x > 7e-4 ? 1.2e-5 : 0;
  const Identification found =
      FindAmong({"sensor_gain", "backlash", "mount_compliance", "sensor_hysteresis"}, data);
  ASSERT_EQ(found.effects.size(), 1u) << Said(found);
  EXPECT_EQ(found.formula.unit, "m");
  EXPECT_THAT(found.formula.text, testing::StartsWith("c1*(1+tanh((x-0.000")) << Said(found);
  EXPECT_NEAR(found.after.values.back(), 0.6e-5, 0.1e-5) << Said(found);
  EXPECT_LT(found.after.channel_ms[0], 0.3 * found.before.channel_ms[0]);
}

}  // namespace
}  // namespace phs::identify::search
